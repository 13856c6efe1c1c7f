/** Files on their way in and out, and the meshes that came with them. */
import { signal, type ReadonlySignal } from '@preact/signals';
import { createEvent, readonly, type EventSource } from '../state/signals.ts';

export interface PendingFile {
  name: string;
  /** A headerless file: the time step is asked for, this one offered (s). */
  offeredStep: number;
}

/** A file that was just put on the stage. */
export interface OpenedFile {
  name: string;
  file: Blob;
  timeStep?: number;
}

/** By `<system>/<model>`; a missing half is the generated one. */
export type Meshes = ReadonlyMap<string, { mdl?: string; mat?: string }>;

export interface FileState {
  /** A file whose time step is asked for. */
  pendingFile: ReadonlySignal<PendingFile | null>;
  /** A large file on its way in. */
  reading: ReadonlySignal<{ name: string; share: number; rows: number } | null>;
  /** A long run is being written as a CSV file. */
  writing: ReadonlySignal<{ name: string; share: number } | null>;
  /** A file on its way from the server: 0 to 1, or null where its length is not known. */
  loading: ReadonlySignal<{ name: string; share: number | null } | null>;
  /** Meshes the person dropped. */
  meshes: ReadonlySignal<Meshes>;
}

type Setter<T> = (value: T) => void;
type ValueOf<S> = S extends ReadonlySignal<infer T> ? T : never;

export interface FileActions {
  setPendingFile: Setter<PendingFile | null>;
  setReading: Setter<ValueOf<FileState['reading']>>;
  setWriting: Setter<ValueOf<FileState['writing']>>;
  setLoading: Setter<ValueOf<FileState['loading']>>;
  setMeshes: Setter<Meshes>;
}

export interface FileSlice {
  state: FileState;
  actions: FileActions;
  opened: EventSource<OpenedFile>;
}

export function createFileState(): FileSlice {
  const pendingFile = signal<PendingFile | null>(null);
  const reading = signal<ValueOf<FileState['reading']>>(null);
  const writing = signal<ValueOf<FileState['writing']>>(null);
  const loading = signal<ValueOf<FileState['loading']>>(null);
  const meshes = signal<Meshes>(new Map());
  return {
    state: {
      pendingFile: readonly(pendingFile),
      reading: readonly(reading),
      writing: readonly(writing),
      loading: readonly(loading),
      meshes: readonly(meshes),
    },
    actions: {
      setPendingFile: (next) => void (pendingFile.value = next),
      setReading: (next) => void (reading.value = next),
      setWriting: (next) => void (writing.value = next),
      setLoading: (next) => void (loading.value = next),
      setMeshes: (next) => void (meshes.value = next),
    },
    opened: createEvent(),
  };
}
