import type { CodeLine } from '#simulation/causes/output';
import type { Simulation } from '#simulation/simulation';
import type { LineEvent } from '#vm/debug/line-watch';
import { ruleOf } from '#vm/debug/stops';
import { variablesReader, type Variables } from '#vm/debug/variables';
import { STEP_US } from '#world/step';
import type { FromLooker, Instant, Look, LookWish, ToLooker } from './protocol';
import { Overtaken, Replays, type Bench } from './replays';

/** Time before a moment at which its line may have begun, in µs: tried one after the other, then from the start. */
const BEFORE_US = [500_000, 5_000_000, 50_000_000] as const;
/** Number of lines before a moment that are remembered at least. Chosen: no one steps back further line by line. */
const MOST_SEEN = 256;
/** Longest time for reading the variables of lines that may never be requested, in ms of wall time. */
const READING_MS = 120;
/** The variables of the lines in this time before a moment, in µs, are read regardless. */
const LAST_US = 20_000;
/** A line that began this long ago, in µs, still counts as current. Chosen: too short to see a robot move. */
const NEAR_US = 100_000;
/** Largest lead of one device's clock over another's, in µs. */
const APART_US = 2 * STEP_US;

/** A part of a run that can no longer change: its lines from one moment to another. */
interface Stretch {
  readonly device: number;
  readonly fromUs: number;
  readonly toUs: number;
  readonly lines: readonly Seen[];
}

/** A line that began. */
interface Seen extends Pick<LineEvent, 'file' | 'line'> {
  readonly timeUs: number;
  /** `null`: not read. */
  readonly look: Look | null;
}

/** Answers the page's questions about a past run, by running it again. */
export class Looker {
  private replays: Replays | null = null;
  private stretch: Stretch | null = null;
  /** Number of the newest request of each kind; requests of one kind do not overtake those of the other. */
  private readonly newest = { look: 0, why: 0 };
  private working: Promise<void> = Promise.resolve();

  constructor(private readonly at: Bench & { post(message: FromLooker): void }) {}

  receive(message: ToLooker): void {
    const { newest } = this;
    const kind = message.type === 'why' ? 'why' : 'look';
    newest[kind] += 1;
    if (message.type === 'look-into') newest.why += 1;
    const turn = newest[kind];
    const mayGoOn = (): boolean => turn === newest[kind];
    this.working = this.working.then(async () => {
      try {
        if (message.type === 'look-into') this.open(message);
        else if (mayGoOn() && this.replays !== null) await this.work(this.replays, message, mayGoOn);
      } catch (error) {
        if (!(error instanceof Overtaken))
          this.at.post({ type: 'look-failed', message: error instanceof Error ? error.message : String(error) });
      }
    });
  }

  private open({ setup, firmware }: Extract<ToLooker, { type: 'look-into' }>): void {
    this.replays?.dispose();
    this.stretch = null;
    this.replays = new Replays(setup, firmware, this.at);
  }

  private async work(
    replays: Replays,
    message: Exclude<ToLooker, { type: 'look-into' }>,
    mayGoOn: () => boolean,
  ): Promise<void> {
    if (message.type === 'look-near') {
      const [near] = BEFORE_US;
      replays.park(await replays.at(Math.max(message.at.timeUs - near, 0), mayGoOn));
      return;
    }
    if (message.type === 'why') return this.why(replays, message, mayGoOn);
    const { ask, wish } = message;
    const look = await this.look(replays, wish, mayGoOn);
    this.at.post({ type: 'looked', ask, look });
    await makeReady(replays, look ?? wish.at, mayGoOn);
  }

  private async why(
    replays: Replays,
    { ask, wish }: Extract<ToLooker, { type: 'why' }>,
    mayGoOn: () => boolean,
  ): Promise<void> {
    const { device, timeUs, printed } = wish;
    const { causes } = replays;
    const untilUs = timeUs + APART_US;
    if (causes.untilUs < untilUs) replays.park(await replays.at(untilUs, mayGoOn));
    const line = printed === undefined ? null : causes.printed(device, timeUs, printed);
    const found = printed === undefined ? causes.at(device, timeUs) : line === null ? [] : [line];
    this.at.post({ type: 'caused', ask, causes: found });
  }

  private look(replays: Replays, wish: LookWish, mayGoOn: () => boolean): Promise<Look | null> {
    const { at } = wish;
    switch (wish.kind) {
      case 'moment':
        return lookAt(replays, at, mayGoOn);
      case 'step':
        return lookAfter(replays, wish, mayGoOn);
      case 'back': {
        const isWithin = isAt(wish.within ?? null);
        return this.lookBefore(replays, at, mayGoOn, (lines) => {
          const last = lines.at(-1);
          return last !== undefined && isWithin(last) ? lines.at(-2) : last;
        });
      }
      case 'error': {
        const isWrong = ({ line }: Seen): boolean => line === wish.line;
        return this.lookBefore(replays, at, mayGoOn, (lines) => lines.findLast(isWrong) ?? lines.at(-1));
      }
      case 'line':
        return this.lookAtLine(replays, wish, mayGoOn);
      default:
        return wish satisfies never;
    }
  }

  /** The last beginning of a line before a moment; the moment itself, if that is long ago: the line is in one long call. */
  private async lookAtLine(
    replays: Replays,
    { at, place }: Extract<LookWish, { kind: 'line' }>,
    mayGoOn: () => boolean,
  ): Promise<Look | null> {
    const begun = await this.lookBefore(replays, at, mayGoOn, (lines) => lines.findLast(isAt(place)) ?? lines.at(-1));
    const isNear = begun !== null && begun.timeUs >= at.timeUs - NEAR_US;
    return isNear ? begun : lookAt(replays, at, mayGoOn);
  }

  /** The line that is chosen of those that began before a moment. */
  private async lookBefore(
    replays: Replays,
    at: Instant,
    mayGoOn: () => boolean,
    choose: (lines: readonly Seen[]) => Seen | undefined,
  ): Promise<Look | null> {
    // In the midst of a line its own beginning is before.
    const limitUs = at.isLine ? at.timeUs : at.timeUs + 1;
    const { stretch } = this;
    const isKnown = stretch?.device === at.device && stretch.fromUs < limitUs && stretch.toUs >= limitUs;
    const known = isKnown ? stretch.lines.filter(({ timeUs }) => timeUs < limitUs) : [];
    let found = choose(known);
    for (const before of [...BEFORE_US, Infinity]) {
      if (found !== undefined) break;
      const fromUs = Math.max(limitUs - before, 0);
      this.stretch = await readStretch(replays, { device: at.device, fromUs, toUs: limitUs }, mayGoOn, () =>
        this.at.nowMs(),
      );
      found = choose(this.stretch.lines);
      if (fromUs === 0) break;
    }
    if (found === undefined) return null;
    return found.look ?? lookAt(replays, { device: at.device, timeUs: found.timeUs, isLine: true }, mayGoOn);
  }
}

/** True for the beginnings of this line. */
const isAt =
  (place: CodeLine | null) =>
  ({ file, line }: Seen): boolean =>
    file === place?.file && line === place.line;

/** Parks a run shortly before a moment: from there the line before is soon found. */
async function makeReady(replays: Replays, { timeUs }: Instant, mayGoOn: () => boolean): Promise<void> {
  const [near] = BEFORE_US;
  if (timeUs < near || replays.hasBetween(timeUs - 2 * near, timeUs - APART_US)) return;
  replays.park(await replays.at(timeUs - near, mayGoOn));
}

/** The moment itself. */
async function lookAt(replays: Replays, at: Instant, mayGoOn: () => boolean): Promise<Look> {
  const run = await standAt(replays, at, mayGoOn);
  replays.park(run, at);
  return { ...at, snapshot: run.snapshot(), variables: readerOf(run, at.device)() };
}

/** The moment at which a step from a moment ends; `null`: not before `untilUs`. */
async function lookAfter(
  replays: Replays,
  { at, step, untilUs }: Extract<LookWish, { kind: 'step' }>,
  mayGoOn: () => boolean,
): Promise<Look | null> {
  const { device } = at;
  const run = await standAt(replays, at, mayGoOn);
  const vm = run.inspect(device);
  if (vm === null) throw new RangeError(`There is no device ${device}.`);
  const rule = ruleOf(step, vm);
  // At its end the present begins: the run itself is there.
  run.watch((event) => run.timeOf(device) >= untilUs || rule(event), device);
  await orPark(replays, run, () => replays.advance(run, untilUs + APART_US, mayGoOn));
  const timeUs = run.timeOf(device);
  const isThere = run.heldBy === device && timeUs < untilUs;
  const after = { device, timeUs, isLine: true };
  replays.park(run, isThere ? after : null);
  return isThere ? { ...after, snapshot: run.snapshot(), variables: readerOf(run, device)() } : null;
}

/** Parks a run at its current time if it is given up on the way. */
async function orPark(replays: Replays, run: Simulation, way: () => Promise<void>): Promise<void> {
  try {
    await way();
  } catch (error) {
    replays.park(run);
    throw error;
  }
}

/** Gives a run that is paused at a moment. */
async function standAt(replays: Replays, at: Instant, mayGoOn: () => boolean): Promise<Simulation> {
  const standing = replays.standing(at);
  if (standing !== null) return standing;
  const { device, timeUs, isLine } = at;
  if (!isLine) return replays.at(timeUs, mayGoOn);
  const run = await replays.at(Math.max(timeUs - APART_US, 0), mayGoOn);
  run.watch(() => run.timeOf(device) >= timeUs, device);
  await orPark(replays, run, () => replays.advance(run, timeUs + APART_US, mayGoOn));
  run.watch(null, device);
  return run;
}

/**
 * The latest lines that begin between two moments. Their variables are read for `READING_MS` of wall time, and in the
 * last `LAST_US` regardless.
 */
async function readStretch(
  replays: Replays,
  { device, fromUs, toUs }: Omit<Stretch, 'lines'>,
  mayGoOn: () => boolean,
  nowMs: () => number,
): Promise<Stretch> {
  const run = await replays.at(fromUs, mayGoOn);
  const startUs = run.timeOf(device);
  const read = readerOf(run, device);
  const seen: Seen[] = [];
  let readingMs = 0;
  run.watch(({ kind, file, line }) => {
    const timeUs = run.timeOf(device);
    if (timeUs >= toUs) return true;
    if (kind !== 'line') return false;
    const startMs = nowMs();
    const isWorth = readingMs < READING_MS || timeUs >= toUs - LAST_US;
    const look = isWorth ? { device, timeUs, isLine: true, snapshot: run.snapshot(), variables: read() } : null;
    readingMs += nowMs() - startMs;
    seen.push({ file, line, timeUs, look });
    if (seen.length >= 2 * MOST_SEEN) seen.splice(0, MOST_SEEN);
    return false;
  }, device);
  await orPark(replays, run, () => replays.advance(run, toUs + APART_US, mayGoOn));
  replays.park(run);
  return { device, fromUs: seen[0]?.timeUs ?? startUs, toUs, lines: seen };
}

/** Reads the variables of a device, whose board may be reset in between. */
function readerOf(run: Simulation, device: number): () => Variables {
  let vm = run.inspect(device);
  if (vm === null) throw new RangeError(`There is no device ${device}.`);
  let read = variablesReader(vm);
  return () => {
    const now = run.inspect(device);
    if (now !== null && now !== vm) read = variablesReader((vm = now));
    return read();
  };
}
