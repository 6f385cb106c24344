import { shallowRef, type ShallowRef } from 'vue';

/** A line that the program of one of several devices printed, or the heading of a run. */
export interface SharedLine {
  readonly id: number;
  /** Place of the device; −1: the heading of the run with the number in `text`. */
  readonly device: number;
  readonly text: string;
  /** Simulated time of its first character. */
  readonly timeUs: number;
}

/** Most lines that are kept. Chosen: more than anyone reads of several devices at once, few enough to draw. */
export const SHARED_LINES = 300;
/** The longest line that is kept, in characters; a longer one goes on in the next. */
const LINE_CHARACTERS = 500;

/**
 * The output of a run's programs, line by line in the order in which the lines end: for the console of all devices, and
 * for looking back.
 */
export class SharedLines {
  /** Oldest first. */
  readonly lines: ShallowRef<readonly SharedLine[]> = shallowRef([]);
  /** Older lines of the present run have been dropped. */
  readonly isCut = shallowRef(false);
  private readonly kept: SharedLine[] = [];
  private hasNew = false;
  private hasDropped = false;
  private open: Map<number, Omit<SharedLine, 'id'>> | null = null;
  private nextId = 1;

  startRun(number: number, devices: number): void {
    this.open = new Map();
    if (devices === 1) this.clear(); // nobody looks at the runs before: the console of the one device has them
    this.add({ device: -1, text: String(number), timeUs: 0 });
  }

  write(text: string, device: number, timeUs: number): void {
    const { open } = this;
    if (open === null) return;
    for (const [index, part] of text.replaceAll('\r', '').split('\n').entries()) {
      if (index > 0) this.end(device);
      const before = open.get(device);
      if (part !== '') open.set(device, { device, timeUs, ...before, text: (before?.text ?? '') + part });
      while ((open.get(device)?.text.length ?? 0) > LINE_CHARACTERS) this.breakLine(device);
    }
  }

  /** Shows the page the lines that have come since. A line that has not ended yet is not shown. */
  show(): void {
    if (!this.hasNew) return;
    this.hasNew = false;
    this.drop(this.kept.length - SHARED_LINES);
    this.isCut.value = this.hasDropped;
    this.lines.value = this.kept.slice();
  }

  clear(): void {
    this.hasNew = true;
    this.hasDropped = false;
    this.kept.length = 0;
    this.open?.clear();
  }

  private end(device: number): void {
    const line = this.open?.get(device);
    this.open?.delete(device);
    if (line !== undefined) this.add(line);
  }

  private breakLine(device: number): void {
    const line = this.open?.get(device);
    if (line === undefined) return;
    this.add({ ...line, text: line.text.slice(0, LINE_CHARACTERS) });
    this.open?.set(device, { ...line, text: line.text.slice(LINE_CHARACTERS) });
  }

  private add(line: Omit<SharedLine, 'id'>): void {
    this.hasNew = true;
    this.kept.push({ ...line, id: this.nextId++ });
    if (this.kept.length > 2 * SHARED_LINES) this.drop(SHARED_LINES);
  }

  private drop(count: number): void {
    if (count <= 0) return;
    this.kept.splice(0, count);
    this.hasDropped = true;
  }
}
