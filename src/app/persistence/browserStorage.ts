/** What this browser stores for the page. Storage may be full, forbidden or gone: nothing here throws, every failure is an answer. */

const PREFIX = 'ripstik';
const DATABASE = 'ripstik-lab';
/** As it was first called: permanent. */
const STORE = 'kept';

export interface BrowserStorage {
  /** Small text, at once; null when there is none or it can't be had. */
  text(name: string): string | null;
  /** The reason when it could not be stored. */
  putText(name: string, text: string): string | null;
  /** Large things, later; undefined when there is none or it can't be had. */
  large(name: string): Promise<unknown>;
  putLarge(name: string, value: unknown): Promise<string | null>;
  /** Everything that this page stored, also what others of its parts did. */
  clear(): Promise<string | null>;
}

export const browserStorage: BrowserStorage = {
  text(name) {
    try {
      return localStorage.getItem(`${PREFIX}.${name}`);
    } catch {
      return null;
    }
  },
  putText(name, text) {
    try {
      localStorage.setItem(`${PREFIX}.${name}`, text);
      return null;
    } catch (error) {
      return reasonOf(error);
    }
  },
  async large(name) {
    try {
      return await within('readonly', (store) => store.get(name));
    } catch {
      return undefined;
    }
  },
  async putLarge(name, value) {
    try {
      await within('readwrite', (store) => (value === null ? store.delete(name) : store.put(value, name)));
      return null;
    } catch (error) {
      return reasonOf(error);
    }
  },
  async clear() {
    try {
      for (const key of Object.keys(localStorage)) if (key.startsWith(PREFIX)) localStorage.removeItem(key);
      await within('readwrite', (store) => store.clear());
      return null;
    } catch (error) {
      return reasonOf(error);
    }
  },
};

/** Finds nothing and keeps nothing. */
export const nothingStored: BrowserStorage = {
  text: () => null,
  putText: () => null,
  large: () => Promise.resolve(undefined),
  putLarge: () => Promise.resolve(null),
  clear: () => Promise.resolve(null),
};

/** One transaction, done when it is on disk. */
async function within(mode: IDBTransactionMode, act: (store: IDBObjectStore) => IDBRequest): Promise<unknown> {
  const database = await open();
  try {
    return await new Promise<unknown>((resolve, reject) => {
      const transaction = database.transaction(STORE, mode);
      const request = act(transaction.objectStore(STORE));
      transaction.oncomplete = () => resolve(request.result);
      transaction.onabort = transaction.onerror = () =>
        reject(transaction.error ?? request.error ?? new Error('the storage gave up'));
    });
  } finally {
    database.close();
  }
}

function open(): Promise<IDBDatabase> {
  return new Promise((resolve, reject) => {
    const request = indexedDB.open(DATABASE, 1);
    request.onupgradeneeded = () => void request.result.createObjectStore(STORE);
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error ?? new Error('the storage can\u2019t be opened'));
    request.onblocked = () => reject(new Error('the storage is in use'));
  });
}

function reasonOf(error: unknown): string {
  return error instanceof DOMException ? error.name : error instanceof Error ? error.message : String(error);
}
