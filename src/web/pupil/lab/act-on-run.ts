import { isSame } from '#core/same';
import type { SceneEdit } from '#scene/edit';

import type { WithLate } from '../../kit/state/late-models';
import { EarlierRuns } from '../../session/run/earlier-runs';
import { Recording } from '../../session/run/recording';
import { repeatInWorker, type Repeated } from '../../session/run/repeat-client';
import { showAgain } from '../../session/run/run-again';
import type { Workplace } from '../../session/work/model/parts';
import { consoleOf } from '../console/parts';
import type { LabModel } from './model/lab-model';

type App = Workplace & WithLate;

/** A run of the series, made once more with all its moments. */
async function remade({ run }: App, lab: LabModel, place: number) {
  const setup = lab.setupAt(place);
  const series = lab.series.value;
  const endUs = series?.runs.get(place)?.drive?.endUs;
  if (setup === null || series === null || endUs === undefined) return null;
  const ends = { untilUs: endUs, untilProgramEnds: series.end.untilProgramEnds };
  const { signal } = new AbortController();
  const wish = { setup, ...ends, momentsSinceUs: -1 };
  const repeated: Repeated = await repeatInWorker(run.engine, wish, () => undefined, signal);
  return { setup, ends, endUs, repeated };
}

/** Shows a run of the series in the time machine. @returns its fingerprint; `null`: it cannot be made */
export async function lookBackOn(app: App, lab: LabModel, place: number): Promise<string | null> {
  const made = await remade(app, lab, place);
  if (made === null) return null;
  const { setup, ends, endUs, repeated } = made;
  const { first, pieces } = repeated;
  if (!app.settings.current.value.showArena) app.settings.change({ showArena: true });
  await showAgain(app.run, { kept: setup, untilUs: endUs, ends, first, pieces, atUs: 0 });
  return repeated.result.traceHash;
}

/** Lets a run of the series drive along as a ghost. @returns whether it can be made */
export async function asGhost(app: App, lab: LabModel, place: number): Promise<boolean> {
  const made = await remade(app, lab, place);
  if (made === null) return false;
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

/** True if the work is no longer the one that the series was made with, the number that was taken from it apart. */
export function isStale(lab: LabModel): boolean {
  const series = lab.series.value;
  if (series === null) return false;
  const made = lab.taken.value === null ? series.base.setup : lab.setupAt(lab.taken.value);
  const { setup: now } = lab.base();
  return made !== null && !isSame([made.scene, made.devices], [now.scene, now.devices]);
}

/** Takes the values of a run over: into the program, where they can be undone, the start or the settings. */
export function takeOver({ work, settings, ...app }: App, lab: LabModel, place: number): void {
  const setup = lab.setupAt(place);
  const series = lab.series.value;
  if (setup === null || series === null) return;
  const { jump } = consoleOf({ work, settings, ...app });
  work.showDevice(0);
  const changed = Object.entries(setup.devices[0].files).flatMap(([file, after]) => {
    const before = work.find(file)?.text;
    return before === undefined || before === after ? [] : [{ file, before, after }];
  });
  // The editor writes the last of them, as a step that it can undo.
  for (const { file, after } of changed.slice(0, -1)) work.setText(file, after);
  const last = changed.at(-1);
  if (last !== undefined) jump.mend(last.file, last.before, last.after);
  const { at, heading } = setup.scene.robot;
  const edit: SceneEdit = { type: 'robot', robot: { at, heading } };
  if (!isSame([at, heading], [work.scene.value.robot.at, work.scene.value.robot.heading])) work.edit(edit);
  const { reality, seed } = setup;
  const varies = series.sweep.varied.some(({ what }) => what.kind === 'reality' || what.kind === 'seed');
  if (varies) settings.change(reality > 0 ? { reality, seed } : { reality });
  lab.taken.value = place;
}
