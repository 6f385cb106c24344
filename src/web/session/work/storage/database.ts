/** A table of the browser's databases, which hold far more than its storage for text, and can say that something is on the disk. */
export interface Table {
  readonly database: string;
  /** Its entries have a `name` each. */
  readonly store: string;
}

const WORKS: Table = { database: 'parcours', store: 'pieces' };

/** A text that is stored under a name. */
export interface Entry {
  readonly name: string;
  readonly text: string;
  /** The time of its last use, in ms since 1970. */
  readonly usedMs: number;
}

/**
 * Acts on the stored entries. Resolves once the changes are on the disk itself, as far as the browser can ensure that.
 * Rejects where the browser has no database or no room.
 */
export async function inStore(
  mode: IDBTransactionMode,
  act: (store: IDBObjectStore) => void,
  table = WORKS,
): Promise<void> {
  const database = await openDatabase(table);
  try {
    await new Promise<void>((resolve, reject) => {
      const transaction = database.transaction(table.store, mode, { durability: 'strict' });
      transaction.oncomplete = () => resolve();
      transaction.onabort = () => reject(transaction.error ?? new Error());
      act(transaction.objectStore(table.store));
    });
  } finally {
    database.close();
  }
}

/** The entries of a name or of a range of names, in their order. */
export async function entriesIn(names: string | IDBKeyRange): Promise<readonly Entry[]> {
  let entries: readonly Entry[] = [];
  await inStore('readonly', (store) => {
    const request = store.getAll(names) as IDBRequest<Entry[]>;
    request.onsuccess = () => (entries = request.result);
  });
  return entries;
}

function openDatabase({ database, store }: Table): Promise<IDBDatabase> {
  return new Promise((resolve, reject) => {
    const request = indexedDB.open(database, 1);
    request.onupgradeneeded = () => {
      request.result.createObjectStore(store, { keyPath: 'name' }).createIndex('used', 'usedMs');
    };
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error ?? new Error());
  });
}
