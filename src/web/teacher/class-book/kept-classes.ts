import { classToText, parseClass } from '#school-class/class-file';
import { mergeClasses } from '#school-class/merge';
import type { SchoolClass } from '#school-class/school-class';

import { entriesIn, inStore, type Entry } from '../../session/work/storage/database';

/** Names of the entries of classes in the browser's database. */
const PREFIX = 'classes.';

/** A class that the browser stores. */
export interface KeptOne {
  readonly key: string;
  readonly schoolClass: SchoolClass;
}

/** The classes in the browser's database, each as its file. */
export class KeptClasses {
  /** The stored texts as this tab knows them, by keys. */
  private readonly known = new Map<string, string>();

  /** All of them, in the order of their keys. Rejects without a database. */
  async read(): Promise<readonly KeptOne[]> {
    const entries = await entriesIn(IDBKeyRange.bound(PREFIX, `${PREFIX}~`));
    const found = entries.flatMap(({ name, text }) => {
      const key = name.slice(PREFIX.length);
      const parsed = parseClass(text);
      if ('problem' in parsed) return []; // of a newer version, perhaps: it stays where it is
      this.known.set(key, text);
      return [{ key, schoolClass: parsed.schoolClass }];
    });
    return found.toSorted((one, other) => Number(one.key) - Number(other.key));
  }

  /** Writes a class. What another tab has written since is joined with it. @returns the class that lies there now */
  async write(key: string, schoolClass: SchoolClass): Promise<SchoolClass> {
    const own = classToText(schoolClass);
    if (this.known.get(key) === own) return schoolClass;
    let written = schoolClass;
    await inStore('readwrite', (store) => {
      const request = store.getAll(PREFIX + key) as IDBRequest<Entry[]>;
      request.onsuccess = () => {
        const { text } = request.result[0] ?? {};
        const other = text === undefined || text === this.known.get(key) ? null : parseClass(text);
        if (other !== null && 'schoolClass' in other) written = mergeClasses(schoolClass, other.schoolClass);
        store.put({ name: PREFIX + key, text: classToText(written), usedMs: Infinity } satisfies Entry);
      };
    });
    this.known.set(key, classToText(written));
    return written;
  }

  /** Deletes a class. */
  async forget(key: string): Promise<void> {
    this.known.delete(key);
    await inStore('readwrite', (store) => void store.delete(PREFIX + key));
  }
}
