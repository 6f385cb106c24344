import { shallowRef, type ShallowRef } from 'vue';

/** Key of the stored break points. */
const KEY = 'parcours.break-points';

/** Lines by the file that they are in, as `fileKey` names it. */
export type LinesByFile = Readonly<Record<string, readonly number[]>>;

/** The break points of the work that is open, stored for the browser's tab. */
export class BreakPoints {
  readonly lines: ShallowRef<LinesByFile>;

  /** @param store of the tab; `null`: nothing can be kept */
  constructor(private readonly store: Pick<Storage, 'getItem' | 'setItem'> | null) {
    this.lines = shallowRef(kept(store));
  }

  of(file: string): readonly number[] {
    return this.lines.value[file] ?? [];
  }

  /** @param lines counted from 1, in any order; lines below 1 and those given twice are left out */
  set(file: string, lines: readonly number[]): void {
    const wanted = [...new Set(lines)].filter((line) => line >= 1).sort((a, b) => a - b);
    if (wanted.join() === this.of(file).join()) return;
    const { [file]: _, ...others } = this.lines.value;
    this.keep(wanted.length === 0 ? others : { ...others, [file]: wanted });
  }

  /** Sets a break point, or removes it if there is one. */
  toggle(file: string, line: number): void {
    const lines = this.of(file);
    this.set(file, lines.includes(line) ? lines.filter((one) => one !== line) : [...lines, line]);
  }

  clear(): void {
    this.keep({});
  }

  private keep(lines: LinesByFile): void {
    this.lines.value = lines;
    try {
      this.store?.setItem(KEY, JSON.stringify(lines));
    } catch {
      // A full store: they last until the page is closed.
    }
  }
}

function kept(store: Pick<Storage, 'getItem'> | null): LinesByFile {
  try {
    const found: unknown = JSON.parse(store?.getItem(KEY) ?? '{}');
    if (typeof found !== 'object' || found === null) return {};
    return Object.fromEntries(Object.entries(found).filter((entry): entry is [string, number[]] => areLines(entry[1])));
  } catch {
    return {};
  }
}

const areLines = (value: unknown): value is number[] =>
  Array.isArray(value) && value.every((line) => Number.isInteger(line) && line >= 1);
