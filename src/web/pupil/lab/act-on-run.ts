import { keptLines } from '#check/task/kept-lines';
import { isSame } from '#core/same';
import type { Base } from '#lab/what';
import { filesByName, MAIN } from '#project/project';
import type { SceneEdit } from '#scene/edit';
import type { RunSetup } from '#simulation/run-setup';

import type { WithLate } from '../../kit/state/late-models';
import { EarlierRuns } from '../../session/run/earlier-runs';
import { Recording } from '../../session/run/recording';
import { repeatInWorker, type Repeated } from '../../session/run/repeat-client';
import { showAgain } from '../../session/run/run-again';
import { examOf } from '../../session/task/exam/exam-model';
import { seedOf } from '../../session/work/hardware/hardware';
import type { Workplace } from '../../session/work/model/parts';
import { consoleOf } from '../console/parts';
import { isSeed, type Settings } from '../../session/work/settings/settings';
import type { LabModel, Series } from './model/lab-model';

type App = Workplace & WithLate;

/** A run of the series that something is done with. */
export interface OfRun {
  readonly lab: LabModel;
  readonly place: number;
  /** Gives it up. */
  readonly signal: AbortSignal;
}

/** A run of the series, made once more with all its moments. */
async function remade({ run }: App, { lab, place, signal }: OfRun) {
  const setup = lab.setupAt(place);
  const series = lab.series.value;
  const endUs = series?.runs.get(place)?.drive?.endUs;
  if (setup === null || series === null || endUs === undefined) return null;
  const ends = { untilUs: endUs, untilProgramEnds: series.end.untilProgramEnds };
  const wish = { setup, ...ends, momentsSinceUs: -1 };
  const repeated: Repeated = await repeatInWorker(run.engine, wish, () => undefined, signal);
  return { setup, ends, endUs, repeated };
}

/**
 * Shows a run of the series in the time machine.
 *
 * @param leave called when it is there: leaves the page of experiments
 * @returns its fingerprint; `null`: it cannot be made
 */
export async function lookBackOn(app: App, of: OfRun, leave: () => void): Promise<string | null> {
  const made = await remade(app, of);
  if (made === null || of.signal.aborted) return null;
  const { setup, ends, endUs, repeated } = made;
  const { first, pieces } = repeated;
  leave();
  if (!app.settings.current.value.showArena) app.settings.change({ showArena: true });
  await showAgain(app.run, { kept: setup, untilUs: endUs, ends, first, pieces, atUs: 0 });
  return repeated.result.traceHash;
}

/** Lets a run of the series drive along as a ghost. @returns whether it can be made */
export async function asGhost(app: App, of: OfRun): Promise<boolean> {
  const made = await remade(app, of);
  if (made === null || of.signal.aborted) return false;
  const { setup, ends, endUs, repeated } = made;
  const { run } = app;
  const earlier = (run.earlier.value ??= new EarlierRuns(run, () => consoleOf(app).console.run.value));
  const { first } = repeated;
  earlier.bring({
    recording: new Recording(setup, null, { pieces: repeated.pieces, untilUs: endUs, ends }),
    scene: setup.scene,
    robots: [first, ...first.others].map(({ robot }) => robot?.type ?? null),
    tookUs: endUs,
  });
  return true;
}

/** The condition of the robot and its chance, as far as they do not vary in the series. */
function condition({ setup: { reality, seed }, usedSeed }: Base, { wish, sweep }: Series): readonly number[] {
  if (wish.kind === 'robots') return [];
  const varies = (kind: 'reality' | 'seed'): boolean => sweep.varied.some(({ what }) => what.kind === kind);
  if (varies('seed')) return varies('reality') ? [] : [reality];
  return varies('reality') ? [usedSeed] : [reality, seed];
}

/** True if the work is no longer the one that the series was made with, the number that was taken from it apart. */
export function isStale(lab: LabModel): boolean {
  const series = lab.series.value;
  if (series === null) return false;
  const made = lab.taken.value === null ? series.base.setup : lab.setupAt(lab.taken.value);
  const now = lab.base();
  const partsOf = (setup: RunSetup, base: Base) => [setup.scene, setup.devices, setup.inputs, condition(base, series)];
  return made !== null && !isSame(partsOf(made, series.base), partsOf(now.setup, now));
}

/** The work as a run of the series would have it. */
interface Change {
  readonly files: readonly { readonly file: string; readonly before: string; readonly after: string }[];
  /** `null`: the robot starts there already. */
  readonly start: SceneEdit | null;
  /** `null`: the robot stays as it is. */
  readonly robot: Partial<Pick<Settings, 'reality' | 'seed'>> | null;
  /** True: the page has no such chance: of a new robot it is always the first, of a used one it has an upper limit. */
  readonly isElsewhere: boolean;
}

function changeTo({ work }: Pick<App, 'work'>, lab: LabModel, place: number): Change | null {
  const setup = lab.setupAt(place);
  const series = lab.series.value;
  if (setup === null || series === null) return null;
  const present = filesByName(work.work.value.project.files);
  const files = Object.entries(setup.devices[0].files).flatMap(([file, after]) => {
    const before = present[file];
    return before === undefined || before === after ? [] : [{ file, before, after }];
  });
  const { at, heading } = setup.scene.robot;
  const { robot } = work.scene.value;
  const isThere = isSame([at, heading], [robot.at, robot.heading]);
  const { reality, seed } = setup;
  const varies = series.sweep.varied.some(({ what }) => what.kind === 'reality' || what.kind === 'seed');
  return {
    files,
    start: isThere ? null : { type: 'robot', robot: { at, heading } },
    robot: varies ? (reality > 0 ? { reality, seed } : { reality }) : null,
    isElsewhere: seedOf({ reality, seed }) !== seed || (reality > 0 && !isSeed(seed)),
  };
}

/** True if nothing that a task locks is changed with the values of a run. */
export function canTake(app: App, lab: LabModel, place: number): boolean {
  const change = changeTo(app, lab, place);
  if (change === null) return false;
  const { locks } = app.work;
  const { state } = examOf(app);
  const isOpen = state.value === 'none' || state.value === 'running';
  const lines = locks.task.value?.locks.lines ?? [];
  const keeps = ({ file, before, after }: Change['files'][number]): boolean =>
    isOpen && (file !== MAIN || lines.length === 0 || keptLines(before, after, lines) !== null);
  const mayMove = !locks.isLocked('course') && ['select', 'rotate', 'start'].some((tool) => locks.hasTool(tool));
  return (
    !change.isElsewhere &&
    change.files.every(keeps) &&
    (change.start === null || mayMove) &&
    (change.robot === null || !locks.isLocked('robot'))
  );
}

/** The way in which values were taken over: `undo` brings the old ones back. */
export type Taken = 'undo' | 'done';

/**
 * Takes the values of a run over: into the program, where they can be undone, the start or the settings.
 *
 * @returns `null`: they are not taken over
 */
export function takeOver(app: App, lab: LabModel, place: number): Taken | null {
  const { work, settings } = app;
  const change = changeTo(app, lab, place);
  if (change === null || !canTake(app, lab, place)) return null;
  const { files, start, robot } = change;
  if (start !== null && !work.edit(start)) return null;
  work.showDevice(0);
  // The editor writes the last of them, as a step that it can undo.
  for (const { file, after } of files.slice(0, -1)) work.setText(file, after);
  const last = files.at(-1);
  if (last !== undefined) consoleOf(app).jump.mend(last.file, last.before, last.after);
  if (robot !== null) settings.change(robot);
  lab.taken.value = place;
  return files.length === 1 && start === null && robot === null ? 'undo' : 'done';
}
