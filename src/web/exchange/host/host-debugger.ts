import { nextTick, watch } from 'vue';

import type { BreakPoint, EmbeddedDebugger, HostStep, ProgramMoment } from '#embed/debugger';
import type { Refusal, SimulatorEvent } from '#embed/simulator';
import { filesOfDevice } from '#project/devices';
import { placeOfDevice } from '#simulation/several/place-of-device';

import type { Debug } from '../../pupil/debug/debug';
import { fileKey } from '../../pupil/debug/file-key';
import { stepAsRan } from '../../pupil/debug/ran-program';
import { fetchAgain } from './fetch-again';
import { wholeRecording } from '../../session/run/fill/whole-recording';
import { hostPast } from './host-past';
import type { HostedPage } from './hosted-page';

/** The page's debugger, for a host. */
export function hostDebugger(app: HostedPage): EmbeddedDebugger {
  const { run, work } = app;
  const placeOf = (device: string | undefined): number | string => placeOfDevice(work.devices.value, device);
  return {
    ...hostPast(app),
    breakPoints(device) {
      const place = placeOf(device);
      return typeof place === 'string' ? place : pointsOf(app, place);
    },
    async setBreakPoints(points, device) {
      const place = placeOf(device);
      if (typeof place === 'string') return place;
      const problems = points.map((point, index) => placeProblem(app, place, point, `points[${index}]`));
      const problem = problems.find((one) => one !== null) ?? null;
      if (problem !== null) return problem;
      const debug = await needed(app);
      await nextTick(); // opening another course clears the points of before
      const { project } = work.work.value;
      for (const { name } of filesOfDevice(project, place))
        debug.points.set(fileKey(project, place, name), points.filter(({ file }) => file === name).map(({ line }) => line)); // prettier-ignore
      await nextTick(); // now the run knows them
      return null;
    },
    async moment(device) {
      const place = placeOf(device);
      if (typeof place === 'string') return place;
      if (run.past.value === null) return momentNow(app, place);
      const look = await (await needed(app)).past.momentOf(place);
      return look ?? 'Another moment was chosen meanwhile, or the program cannot be looked into.';
    },
    async step(step, device) {
      const place = placeOf(device);
      if (typeof place === 'string') return place;
      if (step === 'back') return stepInPast(app, step, place);
      const problem = typeof step === 'string' ? null : placeProblem(app, place, step, 'run-to');
      if (problem !== null) return problem;
      const asRan = stepAsRan(app, place, step);
      if (asRan === null) return 'run-to: no line of the program that runs comes after this one.';
      if (run.past.value !== null) return stepInPast(app, asRan, place);
      if (run.phase.value !== 'paused') return `This needs a run that is paused; it is ${run.phase.value}.`;
      if (run.endings.value[place] !== null) return 'The program has ended: no line begins any more.';
      run.debug.step(asRan, place);
      return null;
    },
  };
}

/** Reports lines, moments and break points of the page to `tell`. @returns ends it */
export function listenToDebugger(app: HostedPage, tell: (event: SimulatorEvent) => void): () => void {
  const { run, work, slot } = app;
  const atOnce = { flush: 'sync' } as const;
  const nameOf = (place: number) => (place === 0 ? {} : { device: work.devices.value[place] ?? '' });
  const ends = [
    watch(
      run.debug.held,
      (held) => {
        const at = held === null ? null : (run.deviceNow(held.device)?.position ?? null);
        if (held === null || at === null) return;
        tell({ type: 'held', timeUs: held.timeUs, file: at.file, line: at.line, ...nameOf(held.device) });
      },
      atOnce,
    ),
    watch(
      () => slot.debug.value?.past.arrived.value ?? null,
      (look) => {
        const [at] = look?.variables.stack ?? [];
        if (look === null || at === undefined) return;
        tell({ type: 'held', timeUs: look.timeUs, file: at.file, line: at.line, ...nameOf(look.device) });
      },
      atOnce,
    ),
    watch(
      () => run.past.value?.timeUs ?? null,
      (timeUs) => tell({ type: 'looking', timeUs }),
      atOnce,
    ),
    watchPoints(app, (points, place) => tell({ type: 'break-points', points, ...nameOf(place) })),
  ];
  return () => {
    for (const end of ends) end();
  };
}

/** The debugger, which the page fetches when somebody needs it. */
async function needed({ slot }: HostedPage): Promise<Debug> {
  await fetchAgain(() => Promise.all([import('../../pupil/debug/debug'), import('../../pupil/debug/editor/marks')]));
  return new Promise((resolve) => slot.need(resolve));
}

/** The program's place at this moment, as the worker reports it. */
async function momentNow({ run }: HostedPage, place: number): Promise<ProgramMoment | string> {
  const hasProgram = (): boolean => run.phase.value === 'running' || run.phase.value === 'paused';
  if (!hasProgram()) return `This needs a run; it is ${run.phase.value}.`;
  const told = new Promise<ProgramMoment | string>((resolve) => {
    const end = watch(
      [run.debug.told, run.phase],
      ([now], [before]) => {
        const isTold = now !== before && now?.device === place;
        if (!isTold && hasProgram()) return;
        end();
        resolve(isTold ? { timeUs: now.timeUs, variables: now.variables } : 'The run has ended.');
      },
      { flush: 'sync' },
    );
  });
  run.debug.inspect(place);
  return told;
}

async function stepInPast(app: HostedPage, step: HostStep, place: number): Promise<Refusal> {
  const before = app.run.past.value;
  if (app.run.phase.value === 'starting' || (await wholeRecording(app.run, 'the inputs')) === null)
    return 'This needs a run that has been.';
  const { past } = await needed(app);
  const isThere = await (step === 'back' ? past.back(place) : past.step(step, place));
  if (isThere) return null;
  if (before === null) app.run.look.leave();
  return step === 'back' ? 'No line began before.' : 'The run has not come to such a line: look-now shows the present.';
}

function pointsOf({ work, slot }: HostedPage, place: number): readonly BreakPoint[] {
  const { project } = work.work.value;
  const points = slot.debug.value?.points;
  return filesOfDevice(project, place).flatMap(({ name }) =>
    (points?.of(fileKey(project, place, name)) ?? []).map((line) => ({ file: name, line })),
  );
}

/** Why a program cannot stop at a line, or `null`. @param where the place in the host's message */
function placeProblem({ work }: HostedPage, place: number, { file, line }: BreakPoint, where: string): Refusal {
  const files = filesOfDevice(work.work.value.project, place);
  const found = files.find(({ name }) => name === file);
  if (found === undefined)
    return `${where}: there is no file "${file}"; the program has ${files.map(({ name }) => name).join(', ')}.`;
  const lines = found.text.split('\n').length;
  return line <= lines ? null : `${where}: ${file} has ${lines} lines, no line ${line}.`;
}

/** Reports all break points of a device whenever they have changed. @returns ends it */
function watchPoints(app: HostedPage, tell: (points: readonly BreakPoint[], place: number) => void): () => void {
  const all = (): readonly string[] => app.work.devices.value.map((_, place) => JSON.stringify(pointsOf(app, place)));
  let told = all();
  return watch(
    () => app.slot.debug.value?.points.lines.value,
    () => {
      const before = told;
      told = all();
      for (const [place, points] of told.entries())
        if (points !== (before[place] ?? '[]')) tell(JSON.parse(points) as readonly BreakPoint[], place);
    },
    { flush: 'sync' },
  );
}
