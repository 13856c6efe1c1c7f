/** What every part of the equations shares. */
import type { Signal } from '@preact/signals';
import { createContext } from 'preact';
import { useContext } from 'preact/hooks';
import type { SystemView } from '../../core/model/system.ts';
import type { Typeset } from '../../core/model/typeset.ts';

export interface Book {
  view: SystemView;
  typeset: Typeset;
  /** The mark that is pointed at, or null. */
  pointed: Signal<string | null>;
  /** Reads out what happened. */
  said: Signal<string>;
}

export const BookContext = createContext<Book | null>(null);

/** A coordinate in words, for titles and for those who hear them. */
export const inWords = ({ view }: Book, name: string): string =>
  view.meta.coordinates.find((c) => c.name === name)?.label ?? name;

export function useBook(): Book {
  const book = useContext(BookContext);
  if (!book) throw new Error('useBook outside of EquationsTool');
  return book;
}
