import type { Recording } from '../../../session/run/recording';
import { printedNumbers } from './printed-numbers';
import { noPoints, type Points, type Series, type SeriesSource } from './series';

/** Most curves that a program can make by printing. Chosen: more names than that are no names. */
const MOST_SERIES = 24;

interface Curve {
  readonly series: Series;
  readonly timesS: number[];
  readonly values: number[];
}

/** Tells curves of one program from those of another that prints the same. */
export interface Whose {
  /** The beginning of their ids. */
  readonly id: string;
  named(name: string): string;
}

/**
 * The numbers that the program of a device prints, a curve for each name; those without a name by their place in the
 * line.
 */
export class PrintedSource implements SeriesSource {
  private readonly curves = new Map<string, Curve>();
  private line = '';
  private lineUs = 0;
  private taken = 0;

  /**
   * @param printed what was printed so far
   * @param unnamed gives the name of a number without one; `place` is 0 where it stands alone, else from 1
   * @param whose tells them from those of another program. Left out: they are of the run
   */
  constructor(
    readonly title: () => string,
    private readonly printed: () => Pick<Recording, 'output' | 'outputGone'>,
    private readonly device: number,
    private readonly unnamed: (place: number) => string,
    private readonly whose: Whose = { id: 'printed', named: (name) => name },
  ) {}

  list(): readonly Series[] {
    return [...this.curves.values()].map(({ series }) => series);
  }

  update(): boolean {
    const { output, outputGone } = this.printed();
    for (const { device, text, timeUs } of output.slice(Math.max(0, this.taken - outputGone)))
      if (device === this.device) this.read(text, timeUs);
    this.taken = outputGone + output.length;
    return false;
  }

  pointsOf(id: string): Points {
    return this.curves.get(id) ?? noPoints;
  }

  private read(text: string, timeUs: number): void {
    const [first = '', ...rest] = text.replaceAll('\r', '').split('\n');
    if (this.line === '') this.lineUs = timeUs;
    this.line += first;
    for (const part of rest) {
      this.end();
      this.line = part;
      this.lineUs = timeUs;
    }
    if (this.line.length > 1000) this.line = this.line.slice(0, 1000); // no such line is numbers
  }

  private end(): void {
    const numbers = printedNumbers(this.line) ?? [];
    for (const [place, { name, value }] of numbers.entries()) {
      const of = numbers.length === 1 ? 0 : place + 1;
      const id = `${this.whose.id} ${name === '' ? of : name}`;
      this.curveOf(id, this.whose.named(name === '' ? this.unnamed(of) : name))?.add(this.lineUs / 1_000_000, value);
    }
  }

  private curveOf(id: string, name: string): { add(timeS: number, value: number): void } | null {
    let curve = this.curves.get(id);
    if (curve === undefined) {
      if (this.curves.size >= MOST_SERIES) return null;
      curve = { series: { id, name, unit: '', isStepped: false }, timesS: [], values: [] };
      this.curves.set(id, curve);
    }
    const { timesS, values } = curve;
    return {
      add(timeS, value) {
        // Of several numbers at one time the last counts: a curve has one value at a time.
        const at = timesS.at(-1) === timeS ? timesS.length - 1 : timesS.length;
        timesS[at] = timeS;
        values[at] = value;
      },
    };
  }
}
