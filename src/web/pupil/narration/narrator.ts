import type { Snapshot } from '#simulation/snapshot';

import { momentOf, type Moment } from './moment';
import type { Watcher } from './news';
import { createPacer } from './pacer';
import { sentence, type Surroundings } from './sentences';
import { watchAhead } from './watch-ahead';
import { watchCamera } from './watch-camera';
import { watchColour } from './watch-colour';
import { watchLine } from './watch-line';
import { watchRest } from './watch-rest';
import { isDecided, watchTask } from './watch-task';
import { watchTurn } from './watch-turn';

/** Follows one run and puts it into words. Times by the clock on the wall, in ms. */
export interface Narrator {
  /** Looks at the newest picture. It may be the same as before: that nothing moves any more is seen in time. */
  see(snapshot: Snapshot, nowMs: number): void;
  /** The text to announce now, if any. */
  next(nowMs: number): string | null;
  /** Ends the run: what waited is dropped, and the robot's place is announced. */
  end(nowMs: number): void;
  /**
   * Waits while something else is said, such as how the run goes.
   *
   * @param ms how long that takes; left out: a few words
   */
  letSpeak(nowMs: number, ms?: number): void;
  /** Drops what waited: the run is paused. */
  pause(): void;
  readonly isWaiting: boolean;
}

/**
 * How long the page takes to say that the run has begun or stopped, and what the verdict is, in ms. Chosen: so many
 * words take so long.
 */
const PAGE_MS = 1200;
const VERDICT_MS = 4000;

export function createNarrator(around: () => Surroundings): Narrator {
  const pacer = createPacer();
  const watchers: readonly Watcher[] = [
    watchTask(() => checkpointsOf(around())),
    ...[watchLine(), watchColour(), watchCamera(), watchAhead(), watchTurn(), watchRest()],
  ];
  let now: Moment | null = null;
  return {
    see(snapshot, nowMs) {
      const before = now;
      const seen = momentOf(snapshot, nowMs);
      now = seen;
      if (seen === null) return;
      if (before !== null && isDecided(before, seen)) {
        pacer.clear(); // what led there is old news
        pacer.letSpeak(nowMs + VERDICT_MS);
      }
      if (before === null) pacer.offer({ topic: 'start', isOnWay: snapshot.timeUs > START_US, seen }, nowMs);
      for (const watch of watchers) for (const news of watch(seen)) pacer.offer(news, nowMs);
    },
    next(nowMs) {
      const latest = now;
      return latest === null ? null : pacer.next(nowMs, (news) => sentence(news, latest, around()));
    },
    end(nowMs) {
      pacer.clear();
      if (now !== null) pacer.offer({ topic: 'rest', seen: now }, nowMs);
    },
    letSpeak: (nowMs, ms = PAGE_MS) => pacer.letSpeak(nowMs + ms),
    pause: () => pacer.clear(),
    get isWaiting() {
      return pacer.isWaiting;
    },
  };
}

/** Time up to which a run has just begun, in simulated µs. */
const START_US = 1_000_000;

/** The numbers of the checkpoints in the order in which they count. */
const checkpointsOf = ({ scene }: Surroundings): readonly number[] =>
  scene.objects
    .flatMap((object) => (object.type === 'checkpoint' ? [object.number] : []))
    .sort((one, other) => one - other);
