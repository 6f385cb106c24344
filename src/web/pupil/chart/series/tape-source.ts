import { readChunk, timesOf, leavesAt, NOTHING_KNOWN, type Chunk, type KnownContent } from '#tape/rows/chunk';
import type { Key, Leaf } from '#tape/rows/leaves';
import type { DeviceSnapshot, Snapshot } from '#simulation/snapshot';

import type { Reading } from './readings';
import { noPoints, type Points, type Series, type SeriesSource } from './series';

/** The run as this source sees it. */
export interface TapedRun {
  /** The pieces of its tape so far. */
  readonly pieces: readonly Uint8Array[];
  /** The run now, which may be later than all pieces. */
  readonly present: Snapshot | null;
}

interface Curve {
  readonly timesS: number[];
  readonly values: (number | null)[];
}

/** Longest stretch in which pieces are read, in ms of wall time: half a frame. */
const SLICE_MS = 8;
/**
 * Stretch over which a speed is measured, in s. Chosen: five moments of the tape; what is in whole 0.1 mm then has no
 * steps.
 */
const RATE_OVER_S = 0.1;

/** The run's measurements: from its tape, and those that are not on it yet from the present moment. */
export class TapeSource implements SeriesSource {
  private told: KnownContent = NOTHING_KNOWN;
  private from: TapedRun['pieces'] | null = null;
  private taken = 0;
  private curves = new Map<string, Curve>();
  private live = new Map<string, Curve>();
  private tapedS = -1;

  constructor(
    readonly title: () => string,
    private readonly readings: readonly Reading[],
    private readonly device: number,
    private readonly run: () => TapedRun,
  ) {}

  list(): readonly Series[] {
    return this.readings;
  }

  update(chosen: ReadonlySet<string>): boolean {
    const wanted = this.readings.filter(({ id }) => chosen.has(id));
    const { pieces, present } = this.run();
    if (pieces !== this.from || wanted.some(({ id }) => !this.curves.has(id))) this.restart(wanted);
    this.from = pieces;
    const untilMs = performance.now() + SLICE_MS;
    while (this.taken < pieces.length && performance.now() < untilMs) {
      const chunk = readChunk(pieces[this.taken] ?? new Uint8Array(), this.told);
      this.taken += 1;
      if (chunk !== null) this.takePiece(chunk, wanted);
    }
    if (present !== null) this.takePresent(present, wanted);
    return this.taken < pieces.length;
  }

  pointsOf(id: string): Points {
    const [taped, live] = [this.curves.get(id), this.live.get(id)];
    const reading = this.readings.find((it) => it.id === id);
    if (taped === undefined || live === undefined || reading === undefined) return noPoints;
    const points = { timesS: [...taped.timesS, ...live.timesS], values: [...taped.values, ...live.values] };
    return reading.isRate ? rateOf(points) : points;
  }

  /** Other curves are wanted, or the tape has other pieces: reads them from the beginning of the tape. */
  private restart(wanted: readonly Reading[]): void {
    this.told = NOTHING_KNOWN;
    this.taken = 0;
    this.tapedS = -1;
    this.curves = curvesFor(wanted);
    this.live = curvesFor(wanted);
  }

  private takePiece(chunk: Chunk, wanted: readonly Reading[]): void {
    this.told = { columns: chunk.columns, values: chunk.values };
    const timesS = (timesOf(chunk) ?? []).map((us) => us / 1_000_000);
    const before: readonly Key[] = this.device === 0 ? [] : ['others', this.device - 1];
    for (const reading of wanted) {
      const leaves = reading.paths.map((path) => leavesAt(chunk, [...before, ...path]));
      const curve = this.curves.get(reading.id);
      for (const [at, timeS] of timesS.entries()) {
        curve?.timesS.push(timeS);
        curve?.values.push(reading.value(leaves.map((of) => of[at])));
      }
    }
    this.tapedS = timesS.at(-1) ?? this.tapedS;
    // The tape has now what was seen before.
    for (const { timesS: seen, values } of this.live.values()) {
      const later = seen.findIndex((timeS) => timeS > this.tapedS);
      const gone = later < 0 ? seen.length : later;
      seen.splice(0, gone);
      values.splice(0, gone);
    }
  }

  private takePresent(present: Snapshot, wanted: readonly Reading[]): void {
    const timeS = present.timeUs / 1_000_000;
    const device = this.device === 0 ? present : present.others[this.device - 1];
    if (device === undefined || timeS <= this.tapedS) return;
    for (const reading of wanted) {
      const live = this.live.get(reading.id);
      if (live === undefined || timeS <= (live.timesS.at(-1) ?? -1)) continue;
      live.timesS.push(timeS);
      live.values.push(reading.value(reading.paths.map((path) => leafIn(device, path))));
    }
  }
}

const curvesFor = (readings: readonly Reading[]): Map<string, Curve> =>
  new Map(readings.map(({ id }) => [id, { timesS: [], values: [] }]));

function leafIn(device: DeviceSnapshot, path: readonly Key[]): Leaf | undefined {
  let at: unknown = device;
  for (const key of path) at = typeof at === 'object' && at !== null ? (at as Record<Key, unknown>)[key] : undefined;
  return at as Leaf | undefined;
}

/** How fast the values grow, in a second, over `RATE_OVER_S` before each. */
function rateOf({ timesS, values }: Points): Points {
  let since = 0;
  const rates = timesS.map((timeS, at) => {
    while (since < at - 1 && (timesS[since + 1] ?? 0) <= timeS - RATE_OVER_S + 1e-9) since += 1;
    const [before, now] = [values[since] ?? null, values[at] ?? null];
    if (before === null || now === null || at === since) return null;
    return (now - before) / (timeS - (timesS[since] ?? 0));
  });
  return { timesS, values: rates };
}
