import { adviceOfRun } from '#advice/of-run';
import { findFact, isEmpty, type Files } from '../program/facts';
import type { Simulation } from '#simulation/simulation';
import type { Reason } from '../result';
import type { WorldVariant } from '../task/task';
import type { RunCheck } from './watchers';

/** End of a run, as far as it explains why something was not reached. */
export interface RunEnd extends Pick<Simulation, 'ended'> {
  readonly hasMoved: boolean;
  /** The first device's program. */
  readonly files: Files;
  readonly world: WorldVariant;
}

/**
 * Why nothing more was reached; `null`: there is nothing to say besides what is missing.
 *
 * @param failedUs when something had failed: then only an earlier end of the program is why
 */
export function reasonByEnd(
  { ended, hasMoved, files, world }: RunEnd,
  check: RunCheck,
  failedUs: number | null,
): Reason | null {
  const byEnd = endReason(ended, files, failedUs);
  if (byEnd !== null || failedUs !== null || hasMoved) return byEnd;
  if (isEmpty(files)) return { code: 'empty', params: {} };
  if (!isOfWay(check)) return null;
  const awaited = ended === null && world.inputs.length === 0 ? awaitedIn(files) : undefined;
  return awaited === undefined ? { code: 'unmoved', params: {} } : { code: 'waits', params: { name: awaited } };
}

/** True for a check that a motionless robot cannot pass. */
const isOfWay = ({ type }: RunCheck): boolean =>
  ['goals', 'reach', 'stop', 'laps', 'checkpoints', 'belongs', 'covered', 'tiles', 'score'].includes(type);

/** Calls of a program that wait for a person. */
const AWAITED = ['button_a', 'button_b', 'pin_logo', 'was_gesture', 'is_gesture', 'input'];

const awaitedIn = (files: Files): string | undefined =>
  AWAITED.find((name) => findFact({ type: 'calls', name }, files).holds);

/** The end of the program, if that explains why something was not reached: not if something had failed before. */
function endReason(ended: Simulation['ended'], files: Files, failedUs: number | null): Reason | null {
  if (ended === null || (failedUs !== null && failedUs < ended.timeUs)) return null;
  if (ended.exception !== null) {
    const { type, message, line } = ended.exception;
    const params = { type, message: message.slice(0, MESSAGE_CHARACTERS), line: line ?? 0 };
    const advice = adviceOfRun(ended.exception, files);
    return { code: 'exception', params, ...(advice && { advice }) };
  }
  return ended.kind === 'finished' ? null : { code: 'panic', params: {} };
}

/** A program may raise an exception with a text of any length. */
const MESSAGE_CHARACTERS = 300;
