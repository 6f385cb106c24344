import { computed, shallowRef } from 'vue';

import { aboutOf, withAbout, type ShelfWork } from '#check/shelf/shelf';
import { workToText } from '#check/shelf/write-shelf';
import { noAbout, type TaskAbout } from '#check/task/about';
import { isSame } from '#core/same';

import { newKey } from '../../session/work/storage/new-key';
import { changeStored, forgetWorks, storeWork, storedWorks } from './kept-shelf';
import { workNameOf } from './work-name-of';

/** A work on the shelf. */
export interface ShelfItem {
  /** Tells it from the others; it stays when the work changes. */
  readonly key: string;
  readonly work: ShelfWork;
  /** Its file. */
  readonly text: string;
  /** False: the browser had no room for it, and it goes with the page. */
  readonly isStored: boolean;
}

/** A work that came onto the shelf: a new one, or in the place of an earlier one of its name. */
export interface KeptWork {
  readonly isNew: boolean;
  readonly isStored: boolean;
  /** Takes it away again, or brings the earlier one back. */
  readonly undo: () => Promise<void>;
}

/**
 * The tasks and series of a teacher, as this browser keeps them. Each change is written at once, onto what lies there
 * now: what another tab has done in the meantime stays.
 */
export class TaskShelf {
  readonly items = shallowRef<readonly ShelfItem[]>([]);
  /** True once the stored works are there. */
  readonly isReady = shallowRef(false);
  /** True if something on the shelf would be lost with the page. */
  readonly isUnsaved = computed(() => this.items.value.some(({ isStored }) => !isStored));
  private working: Promise<void>;

  constructor() {
    this.working = this.read();
  }

  /** Reads the stored works anew: another tab may have changed them. */
  refresh(): Promise<void> {
    return this.after(() => this.read());
  }

  /**
   * Puts a work onto the shelf, in the place of one of the same kind and name; it keeps the details of that one if it has
   * none. One that another tab has written since stays beside it.
   */
  async keep(work: ShelfWork): Promise<KeptWork> {
    let kept: KeptWork = { isNew: true, isStored: false, undo: () => Promise.resolve() };
    await this.after(async () => {
      const before = this.items.value;
      await this.read();
      const same = this.items.value.find((one) => one.work.kind === work.kind && nameOf(one) === nameOf({ work }));
      const isKnown = same !== undefined && before.some(({ key, text }) => key === same.key && text === same.text);
      const earlier = isKnown ? same : null;
      const about = earlier === null ? noAbout : (aboutOf(earlier.work) ?? noAbout);
      const next = isSame(aboutOf(work), noAbout) && about !== noAbout ? withAbout(work, about) : work;
      const isStored = await this.put(earlier?.key ?? newKey(this.items.value), next);
      const { key } = this.items.value[0] ?? { key: '' };
      const undo = (): Promise<void> =>
        this.after(async () => {
          if (earlier === null) await this.drop([key]);
          else await this.put(key, earlier.work);
        });
      kept = { isNew: earlier === null, isStored, undo };
    });
    return kept;
  }

  /** Changes the details of a work. */
  setAbout({ key, work }: ShelfItem, about: TaskAbout): Promise<void> {
    return this.after(async () => {
      try {
        const now = await changeStored(key, work, (lying) => withAbout(lying, about));
        this.replace({ ...now, isStored: true });
      } catch {
        const changed = withAbout(work, about);
        this.replace({ key, work: changed, text: workToText(changed), isStored: false });
      }
    });
  }

  /** Takes works away. @returns a function that brings them back */
  remove(items: readonly ShelfItem[]): () => Promise<void> {
    void this.after(() => this.drop(items.map(({ key }) => key)));
    return () =>
      this.after(async () => {
        for (const { key, work } of items.toReversed()) await this.put(key, work);
      });
  }

  private after(act: () => Promise<void>): Promise<void> {
    this.working = this.working.then(act);
    return this.working;
  }

  private async read(): Promise<void> {
    try {
      const stored = await storedWorks();
      const lost = this.items.value.filter(({ isStored }) => !isStored);
      const others = stored.filter(({ key }) => lost.every((one) => one.key !== key));
      this.items.value = [...lost, ...others.map((one) => ({ ...one, isStored: true }))];
    } catch {
      // A browser without a database has stored nothing.
    }
    this.isReady.value = true;
  }

  /** Writes a work and puts it first. @returns whether the browser has stored it */
  private async put(key: string, work: ShelfWork): Promise<boolean> {
    const text = workToText(work);
    const isStored = await storeWork(key, text).then(
      () => true,
      () => false,
    );
    this.items.value = [{ key, work, text, isStored }, ...this.items.value.filter((one) => one.key !== key)];
    return isStored;
  }

  private async drop(keys: readonly string[]): Promise<void> {
    this.items.value = this.items.value.filter(({ key }) => !keys.includes(key));
    await forgetWorks(keys).catch(() => undefined);
  }

  private replace(item: ShelfItem): void {
    this.items.value = this.items.value.map((one) => (one.key === item.key ? item : one));
  }
}

const nameOf = ({ work }: Pick<ShelfItem, 'work'>): string => workNameOf(work);
