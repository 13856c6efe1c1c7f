/** A lesson that is no part of the page: from a file, or out of a link. Loaded with the first of them. */
import { readLesson, type Lesson } from '../../core/lessons/lesson.ts';
import { packText, unpackText } from '../../core/scenario/packed.ts';
import { LONGEST_LINK } from '../../core/scenario/link.ts';
import { ownId } from '../../core/scenario/own.ts';
import { ScenarioError } from '../../core/scenario/types.ts';

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
 * The lesson of an address.
 *
 * @param hash of the address
 * @returns null where it is no address of a lesson
 * @throws Error that says in words what is wrong with it
 */
export function lessonInAddress(hash: string): OwnLesson | null {
  const packed = IN_ADDRESS.exec(hash)?.[1];
  return packed === undefined ? null : lessonOf(unpackText(packed, LARGEST));
}
