/** A lesson that is no part of the page: from a file, or out of a link. Loaded with the first of them. */
import { readLesson, type Lesson } from '../../core/lessons/lesson.ts';
import { packText, unpackText } from '../../core/scenario/packed.ts';
import { LONGEST_LINK } from '../../core/scenario/link.ts';
import { ownId } from '../../core/scenario/own.ts';
import { ScenarioError } from '../../core/scenario/types.ts';
import type { App } from '../app.ts';

export interface OwnLesson extends Lesson {
  /** Of its text: what was answered is kept under it. */
  id: string;
  /** As it was written. */
  text: string;
}

/** Bytes; more is refused before it is read. */
const LARGEST = 200_000;
const IN_ADDRESS = /^#?lesson=([\w-]*)$/;

/**
 * @param file Markdown
 * @throws ScenarioError with the line of what is wrong
 */
export async function lessonIn(file: Blob): Promise<OwnLesson> {
  if (file.size > LARGEST)
    throw new ScenarioError('', `it is larger than the ${LARGEST / 1000} kB that a lesson may have`);
  return lessonOf(await file.text());
}

function lessonOf(text: string): OwnLesson {
  return { ...readLesson(text), id: ownId(text), text };
}

/**
 * The text after `#` that opens a lesson: all of it is in there, packed.
 *
 * @param lesson of one's own
 * @returns null where it would be longer than addresses carry
 */
export function lessonLink({ text }: OwnLesson): string | null {
  const link = `lesson=${packText(text)}`;
  return link.length > LONGEST_LINK ? null : link;
}

/**
 * Opens the lesson of the address beside what is on the stage; a broken one is told.
 *
 * @param app that shows it
 * @param hash of the address
 * @returns whether the address is one of a lesson
 */
export function openLessonLink({ actions }: App, hash: string): boolean {
  const packed = IN_ADDRESS.exec(hash)?.[1];
  if (packed === undefined) return false;
  try {
    actions.setLesson(lessonOf(unpackText(packed, LARGEST)));
    actions.set('tool', 'lessons');
  } catch (error) {
    const why = error instanceof Error ? error.message : String(error);
    actions.report('error', 'The lesson in the address can\u2019t be read', [why]);
  }
  return true;
}
