import { vi } from 'vitest';

/** The content of the database, by name. */
type Entries = Map<string, { name: string; usedMs: number; text?: string }>;

/** A browser's database in memory, as far as the storage of work uses one. */
export interface MemoryDatabase {
  /** The content of the disk. */
  readonly entries: Entries;
  /** The durability that each writing transaction was asked for. */
  readonly durabilities: (string | undefined)[];
  /** From now on no transaction comes to its end before `release` is called. */
  hold(): void;
  release(): void;
}

interface Range {
  readonly from: string;
  readonly to: string;
}

/**
 * Puts a database in the place of the browser's.
 *
 * @param hasRoom `false`: the browser takes nothing
 */
export function stubDatabase(hasRoom = true): MemoryDatabase {
  const entries: Entries = new Map();
  const durabilities: (string | undefined)[] = [];
  let gate: Promise<void> = Promise.resolve();
  let open = (): void => undefined;
  const isIn = (name: string, query: string | Range): boolean =>
    typeof query === 'string' ? name === query : name >= query.from && name <= query.to;
  function transaction(_: string, mode: string, options?: { durability?: string }) {
    if (mode === 'readwrite') durabilities.push(options?.durability);
    const acts: (() => void)[] = [];
    const later = <T>(result: () => T) => {
      const request: { result?: T; onsuccess?: () => void } = {};
      acts.push(() => {
        request.result = result();
        request.onsuccess?.();
      });
      return request;
    };
    const names = (query: string | Range): string[] => [...entries.keys()].filter((name) => isIn(name, query)).sort();
    const store = {
      put: (entry: { name: string; usedMs: number }) => later(() => entries.set(entry.name, entry)),
      delete: (query: string | Range) => later(() => names(query).forEach((name) => entries.delete(name))),
      getAll: (query: string | Range) => later(() => names(query).map((name) => entries.get(name))),
      getAllKeys: (query: string | Range) => later(() => names(query)),
    };
    const self: Record<string, unknown> = { objectStore: () => store, error: new Error('quota') };
    void gate.then(() => {
      if (!hasRoom && mode === 'readwrite') return (self['onabort'] as () => void)();
      for (let act = acts.shift(); act !== undefined; act = acts.shift()) act();
      return (self['oncomplete'] as () => void)();
    });
    return self;
  }
  const request: { result: object; onsuccess?: () => void } = { result: { transaction, close: () => undefined } };
  vi.stubGlobal('IDBKeyRange', { bound: (from: string, to: string): Range => ({ from, to }) });
  vi.stubGlobal('indexedDB', {
    open: () => {
      const own = { ...request };
      queueMicrotask(() => own.onsuccess?.());
      return own;
    },
  });
  return {
    entries,
    durabilities,
    hold() {
      gate = new Promise((resolve) => (open = resolve));
    },
    release: () => open(),
  };
}
