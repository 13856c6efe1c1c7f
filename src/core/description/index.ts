/**
 * Own systems: a text becomes a view at once and a system when its equations are wanted. docs/own-systems.md teaches the
 * language, docs/decisions/0022-own-systems.md says how it is built and what stays as it is.
 */
import type { System, SystemView } from '../model/system.ts';
import { ownId } from '../scenario/own.ts';
import { GrowthError } from './graph.ts';
import type { Model } from './model.ts';
import { systemOf, viewOf, type DeriveOptions } from './mount.ts';
import { readDescription, type Reading } from './read.ts';
import { DescriptionError } from './tokens.ts';

export { sketchOf } from './drawing.ts';
export { vocabulary } from './vocabulary.ts';
export { LONGEST_DESCRIPTION } from './read.ts';
export { DescriptionError } from './tokens.ts';

export interface SystemReading extends Reading {
  /** Null where there are faults. */
  view: SystemView | null;
}

/**
 * Reads a text, in milliseconds: its faults, its names, and what the page shows of it. Throws nothing.
 *
 * @param text the description
 */
export function readSystem(text: string): SystemReading {
  const reading = readDescription(text);
  if (!reading.model) return { ...reading, view: null };
  try {
    return { ...reading, view: viewOf(reading.model, ownId(text), text) };
  } catch (error) {
    if (error instanceof DescriptionError) return { ...reading, model: null, faults: [error], view: null };
    if (error instanceof GrowthError)
      return { ...reading, model: null, faults: [new DescriptionError(error.message, 0)], view: null };
    throw error;
  }
}

/**
 * The equations of a model.
 *
 * @param model what was read of a description
 * @param view what the page shows of the model
 * @param options what is told of progress
 * @throws DescriptionError or GrowthError, which `faultOf` words
 */
export function deriveSystem(model: Model, view: SystemView, options?: DeriveOptions): System {
  return systemOf(model, view, options);
}

/**
 * What a person can mend, in a sentence; null for any other error.
 *
 * @param error anything that was thrown
 */
export function faultOf(error: unknown): string | null {
  return error instanceof DescriptionError || error instanceof GrowthError ? error.message : null;
}
