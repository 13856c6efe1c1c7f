/** Files on their way in and out, and the meshes that came with them. */
import { signal, type ReadonlySignal } from '@preact/signals';
import type { OwnLesson } from './ownLesson.ts';
import type { StudyResults } from '../../core/sweep/studyResults.ts';
import type { ImportChoices, Question } from '../../csv/plan.ts';
import { createEvent, readonly, type EventSource } from '../state/signals.ts';

/** A file that is not read before a question is answered: the time step of one without times. */
export interface PendingFile {
  name: string;
  question: Question;
}

/** Choices with which the file on the stage can't be read, and why; it stays as it is. */
export interface RefusedReading {
  choices: ImportChoices;
  message: string;
}

/** A file that was just put on the stage. */
export interface OpenedFile {
  name: string;
  file: Blob;
  /** What the person chose for its reading. */
  choices: ImportChoices;
}

/** By `<system>/<model>`; a missing half is the generated one. */
export type Meshes = ReadonlyMap<string, { mdl?: string; mat?: string }>;

export interface FileState {
  pendingFile: ReadonlySignal<PendingFile | null>;
  /** The file on the stage is being read again with these choices; the motion stays until it is. */
  readingAgain: ReadonlySignal<ImportChoices | null>;
  /** What was chosen last can't be read yet; the next choice comes on top of it. */
  refusedReading: ReadonlySignal<RefusedReading | null>;
  /** A large file on its way in. */
  reading: ReadonlySignal<{ name: string; share: number; rows: number } | null>;
  /** A long run is being written as a CSV file. */
  writing: ReadonlySignal<{ name: string; share: number } | null>;
  /** A file on its way from the server: 0 to 1, or null where its length is not known. */
  loading: ReadonlySignal<{ name: string; share: number | null } | null>;
  /** The results of a sweep that were opened last. */
  study: ReadonlySignal<StudyResults | null>;
  /** A lesson of the person's own, while it is open. */
  lesson: ReadonlySignal<OwnLesson | null>;
  /** Meshes the person dropped. */
  meshes: ReadonlySignal<Meshes>;
}

type Setter<T> = (value: T) => void;
type ValueOf<S> = S extends ReadonlySignal<infer T> ? T : never;

export interface FileActions {
  setPendingFile: Setter<PendingFile | null>;
  setReadingAgain: Setter<ImportChoices | null>;
  setRefusedReading: Setter<RefusedReading | null>;
  setReading: Setter<ValueOf<FileState['reading']>>;
  setWriting: Setter<ValueOf<FileState['writing']>>;
  setLoading: Setter<ValueOf<FileState['loading']>>;
  setStudy: Setter<StudyResults | null>;
  setLesson: Setter<OwnLesson | null>;
  setMeshes: Setter<Meshes>;
}

export interface FileSlice {
  state: FileState;
  actions: FileActions;
  opened: EventSource<OpenedFile>;
}

export function createFileState(): FileSlice {
  const pendingFile = signal<PendingFile | null>(null);
  const readingAgain = signal<ImportChoices | null>(null);
  const refusedReading = signal<RefusedReading | null>(null);
  const reading = signal<ValueOf<FileState['reading']>>(null);
  const writing = signal<ValueOf<FileState['writing']>>(null);
  const loading = signal<ValueOf<FileState['loading']>>(null);
  const study = signal<StudyResults | null>(null);
  const lesson = signal<OwnLesson | null>(null);
  const meshes = signal<Meshes>(new Map());
  return {
    state: {
      pendingFile: readonly(pendingFile),
      readingAgain: readonly(readingAgain),
      refusedReading: readonly(refusedReading),
      reading: readonly(reading),
      writing: readonly(writing),
      loading: readonly(loading),
      study: readonly(study),
      lesson: readonly(lesson),
      meshes: readonly(meshes),
    },
    actions: {
      setPendingFile: (next) => void (pendingFile.value = next),
      setReadingAgain: (next) => void (readingAgain.value = next),
      setRefusedReading: (next) => void (refusedReading.value = next),
      setReading: (next) => void (reading.value = next),
      setWriting: (next) => void (writing.value = next),
      setLoading: (next) => void (loading.value = next),
      setStudy: (next) => void (study.value = next),
      setLesson: (next) => void (lesson.value = next),
      setMeshes: (next) => void (meshes.value = next),
    },
    opened: createEvent(),
  };
}
