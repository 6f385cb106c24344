import { findRobot } from '#robots/index';
import type { RunSetup } from '#simulation/run-setup';
import type { Snapshot } from '#simulation/snapshot';

import { repeatInWorker } from '../../../session/run/repeat-client';
import type { RunModel } from '../../../session/run/run-model';
import { emptyTape, unpackTape, type RunTape } from '../../../session/run/unpack-tape';
import { runPainter, type RunPainter } from '../../print/run/run-painter';
import { matchMarks } from './match-marks';

/** A match that can be watched: its run, made a second time, with all of its moments. */
export interface WatchedRun {
  readonly setup: RunSetup;
  readonly tape: RunTape;
  readonly first: Snapshot;
  readonly endMs: number;
}

/** Time that is shown after the decision, in ms: one that has been pushed out is seen leaving. */
const AFTER_MS = 1000;
/** Length of a match without a decision, in ms: more of it is not shown. */
const UNDECIDED_MS = 60_000;

/**
 * Runs a match again for its moments: those of all matches would be too many to keep.
 *
 * @param atMs time of its decision
 * @returns `null`: nobody wants it any more, or it cannot run
 */
export async function watchedRun(
  engine: RunModel['engine'],
  { setup, atMs }: { readonly setup: RunSetup; readonly atMs: number | null },
  signal: AbortSignal,
): Promise<WatchedRun | null> {
  const untilUs = 1000 * (atMs === null ? UNDECIDED_MS : Math.ceil(atMs) + AFTER_MS);
  const wish = { setup, untilUs, untilProgramEnds: false, momentsSinceUs: -1 };
  const repeated = await repeatInWorker(engine, wish, () => undefined, signal).catch(() => null);
  if (repeated === null) return null;
  const tape = emptyTape();
  const unpacking = { into: tape, devices: () => setup.devices.length, isWanted: () => !signal.aborted };
  const isWhole = await unpackTape(repeated.pieces, unpacking);
  return isWhole && tape.rows.endUs > 0 ? { setup, tape, first: repeated.first, endMs: tape.rows.endUs / 1000 } : null;
}

/** How far a robot reaches if its outline is not known, in mm. */
const REACH_MM = 70;

/**
 * A painter of the moments of a match.
 *
 * @param sides the number of each device's program, and the colour of that number
 */
export function matchPainter(
  { setup, tape, first }: WatchedRun,
  sides: readonly { readonly number: number; readonly color: string }[],
  longestPx: number,
): Promise<RunPainter> {
  const robots = setup.devices.map(({ robot: id, robotOptions = {} }) => ({
    robot: findRobot(id),
    options: robotOptions,
  }));
  const reaches = robots.map(({ robot }) => Math.max(...(robot?.body.outlineMm.flat() ?? []).map(({ x, y }) => Math.hypot(x, y)), 0) || REACH_MM); // prettier-ignore
  const marks = matchMarks(
    tape.trails,
    sides.map((side, place) => ({ ...side, reachMm: reaches[place] ?? REACH_MM })),
  );
  const colors = robots.map((_, place) => place);
  return runPainter({ scene: setup.scene, robots, colors, trails: null, marks }, longestPx, first);
}
