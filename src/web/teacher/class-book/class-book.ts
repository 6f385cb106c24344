import { computed, shallowRef, watch } from 'vue';

import type { SchoolClass } from '#school-class/school-class';

import { newKey } from '../../session/work/storage/new-key';
import type { KeptClasses } from './kept-classes';

/** A class that is open on this page. */
export interface OpenClass {
  /** Tells it from the others; it stays when the name changes. */
  readonly key: string;
  readonly schoolClass: SchoolClass;
  /** True if this browser stores it. */
  readonly isKept: boolean;
  /** The class as the browser has it; `null`: it has none. */
  readonly stored: SchoolClass | null;
  /** As it is in a file; `null`: in none. */
  readonly inFile: SchoolClass | null;
}

/** After a change that goes on, only its end is written. Chosen, in ms. */
const QUIET_MS = 300;

/**
 * The classes of a teacher: those that this browser stores, and those that were opened or begun. What is stored follows each
 * change; where another tab has changed the same class, both changes hold.
 */
export class ClassBook {
  readonly classes = shallowRef<readonly OpenClass[]>([]);
  /** True once the stored classes are there. */
  readonly isReady = shallowRef(false);
  /** True if the browser could not store a class. */
  readonly hasFailed = shallowRef(false);
  private readonly chosenKey = shallowRef('');
  /** The class that was chosen since the page was opened, or the only one; `null`: it is not certain which one is meant. */
  readonly certain = computed(() => {
    const all = this.classes.value;
    return all.find(({ key }) => key === this.chosenKey.value) ?? (all.length === 1 ? all[0] : undefined) ?? null;
  });
  /** The class in sight; `null`: there is none. */
  readonly chosen = computed(() => this.certain.value ?? this.classes.value[0] ?? null);
  /** True if a change would be lost with the page. */
  readonly isUnsaved = computed(() =>
    this.classes.value.some(({ isKept, stored, inFile, schoolClass }) => (isKept ? stored : inFile) !== schoolClass),
  );
  /** Ends once the stored classes are there. */
  readonly ready: Promise<void>;
  private working: Promise<void>;
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly kept: KeptClasses) {
    this.ready = this.bringBack();
    this.working = this.ready;
    watch(this.classes, () => {
      clearTimeout(this.timer);
      this.timer = setTimeout(() => void this.store(), QUIET_MS);
    });
  }

  choose(key: string): void {
    this.chosenKey.value = key;
  }

  /** Adds a class and shows it. @param isInFile true if it came from a file */
  add(schoolClass: SchoolClass, isInFile: boolean): void {
    const key = newKey(this.classes.value);
    const one = { key, schoolClass, isKept: false, stored: null, inFile: isInFile ? schoolClass : null };
    this.classes.value = [...this.classes.value, one];
    this.chosenKey.value = key;
  }

  /** Changes the class in sight. @returns a function that takes it back */
  change(make: (now: SchoolClass) => SchoolClass): () => void {
    const now = this.chosen.value;
    if (now === null) return () => undefined;
    this.replace(now.key, { schoolClass: make(now.schoolClass) });
    return () => this.replace(now.key, { schoolClass: now.schoolClass });
  }

  /** Has the browser store the class in sight, or forget it. */
  keep(isKept: boolean): Promise<void> {
    const { key } = this.chosen.value ?? {};
    if (key === undefined) return Promise.resolve();
    this.replace(key, { isKept });
    return isKept ? this.store() : this.after(() => this.kept.forget(key));
  }

  /** Notes that the class in sight is in a file as it is now. */
  noteSaved(): void {
    const now = this.chosen.value;
    if (now !== null) this.replace(now.key, { inFile: now.schoolClass });
  }

  /** Takes the class in sight away, here and from the browser. @returns a function that brings it back */
  remove(): () => void {
    const [all, now] = [this.classes.value, this.chosen.value];
    if (now === null) return () => undefined;
    this.classes.value = all.filter((one) => one !== now);
    if (now.isKept) void this.after(() => this.kept.forget(now.key));
    return () => {
      this.classes.value = [...this.classes.value, now];
      this.chosenKey.value = now.key;
    };
  }

  private replace(key: string, change: Partial<OpenClass>): void {
    this.classes.value = this.classes.value.map((one) => (one.key === key ? { ...one, ...change } : one));
  }

  /** A class that was begun before the stored ones were there, with a key that none of them has. */
  private withOwnKey(one: OpenClass, stored: readonly OpenClass[]): OpenClass {
    if (stored.every(({ key }) => key !== one.key)) return one;
    const key = newKey([...stored, ...this.classes.value]);
    if (this.chosenKey.value === one.key) this.chosenKey.value = key;
    return { ...one, key };
  }

  private after(act: () => Promise<void>): Promise<void> {
    this.working = this.working.then(act).catch(() => void (this.hasFailed.value = true));
    return this.working;
  }

  private async bringBack(): Promise<void> {
    try {
      const found = await this.kept.read();
      const stored = found.map(({ key, schoolClass }) => ({ key, schoolClass, isKept: true, stored: schoolClass, inFile: null })); // prettier-ignore
      this.classes.value = [...stored, ...this.classes.value.map((one) => this.withOwnKey(one, stored))];
    } catch {
      // A browser without a database has stored nothing.
    }
    this.isReady.value = true;
  }

  /** Writes the stored classes that have changed; what another tab has added meanwhile is in them afterwards. */
  private store(): Promise<void> {
    return this.after(async () => {
      for (const { key, isKept, schoolClass } of this.classes.value) {
        if (!isKept) continue;
        const written = await this.kept.write(key, schoolClass);
        const now = this.classes.value.find((one) => one.key === key);
        // What has changed meanwhile is written next.
        if (now?.schoolClass === schoolClass && now.stored !== written)
          this.replace(key, { schoolClass: written, stored: written });
      }
      this.hasFailed.value = false;
    });
  }
}
