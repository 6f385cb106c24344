import { watch } from 'vue';
import type { HostedPage } from './hosted-page';

import { filesProblem } from '#embed/files-problem';
import type { ArenaMode, EmbeddedSimulator, HostSettings, Refusal, SimulatorEvent } from '#embed/simulator';
import { withFiles } from '#project/devices';
import { isSame } from '#core/same';
import type { Project } from '#project/project';
import { editProblem } from '#scene/check-edit';
import type { SceneEdit } from '#scene/edit';
import type { Scene } from '#scene/scene';
import { placeOfDevice } from '#simulation/several/place-of-device';

import { stampSettings } from '../../session/work/stamp-settings';
import { hardwareNow } from '../../session/work/hardware/use-hardware';
import type { RunParts } from '../../session/run/parts';
import type { WorkParts } from '../../session/work/model/parts';
import type { VisitParts } from '../../session/visit/parts';
import type { LayoutParts } from '../../session/layout/parts';
import { hasNothingOwn } from '../../session/work/use-courses';
import { withoutHandedOut } from '../../session/work/model/task-locks';
import { workName } from '../../session/work/work-name';
import { isSameWork } from '../../session/work/storage/history';
import { travelling } from '../../session/work/settings/travelling';
import { presentProject } from '../../session/work/save-work';
import { heldSettings } from '../../session/visit/held-settings';
import { hostDebugger, listenToDebugger } from './host-debugger';
import { hostInputs } from './host-inputs';
import { settingsProblem } from './settings-problem';
import { startRun } from './start-run';

/** The app, as its host sees it. A host's actions use the same code as the page's own controls. */
export function appSimulator(app: HostedPage): EmbeddedSimulator {
  const { run } = app;
  const change = (wish: HostSettings): Refusal => changeSettings(app, wish);
  const inputs = hostInputs(app);
  return {
    phase: () => run.phase.value,
    nowUs: () => run.nowUs.value,
    snapshot: () => run.snapshot.value,
    ended: () => run.endings.value[0] ?? null,
    board: () => hardwareNow(app, 0)?.board.id ?? '',
    project: () => presentProject(app),
    mode: () => app.mode.current.value,
    settings: () => settingsOf(app),
    sensorWishes: () => app.sensors.wishes.value,
    ...hostWork(app),
    change,
    enterMode: (mode) => enterMode(app, mode),
    ...hostRuns(app),
    input: (action, device) => inputs.take(action, device),
    clearConsole: () => app.console.clear(),
    debug: hostDebugger(app),
    onRunAsked: (ask) => void (run.ask.value = ask),
    listen: (listener) =>
      listenTo(app, (event) => {
        if (event.type !== 'sensed' || !inputs.isOwn()) listener(event);
      }),
  };
}

/** Opening and editing. */
function hostWork(app: HostedPage): Pick<EmbeddedSimulator, 'openProject' | 'setFiles' | 'setScene' | 'edit'> {
  const { run, work, host, hand } = app;
  /** The project that a host opened last. The host has its own copy, so it need not be put aside. */
  let brought: Project | null = null;
  /** The name under which the pupil's own work is put aside, or `null` without such work. */
  function nameOfOwn(): string | null {
    const { project } = work.work.value;
    if (!host.wish.keepsWork || hasNothingOwn(project) || (brought !== null && isSameWork(project, brought)))
      return null;
    stampSettings(app);
    return workName(app);
  }
  function open(project: Project): void {
    void run.reset();
    hand.reset();
    work.openProject(project, nameOfOwn());
    brought = work.work.value.project;
    work.isBrought = true;
  }
  return {
    openProject(project) {
      const { settings } = project;
      const problem = filesProblem(project.files) ?? (settings ? settingsProblem(settings) : null);
      if (problem !== null) return problem;
      open(project);
      if (settings !== undefined) bringSettings(app, settings);
      return null;
    },
    setFiles(files, device) {
      const { project } = work.work.value;
      const place = placeOfDevice(work.devices.value, device);
      const problem = filesProblem(files) ?? (typeof place === 'string' ? place : null);
      if (problem !== null) return problem;
      const wished = withFiles(project, Number(place), files);
      const given = work.locks.changed(project, wished, false);
      if (given === null) return KEPT;
      open(given);
      return null;
    },
    setScene(scene: Scene) {
      open({ ...withoutHandedOut(work.work.value.project), scene, course: null });
      return null;
    },
    edit(edit: SceneEdit) {
      const problem = editProblem(work.scene.value, edit);
      if (problem !== null) return problem.message;
      if (work.staysAsItIs()) return LOOKED_BACK;
      if (work.locks.refusesStep('edit', { edit })) return KEPT;
      work.edit(edit);
      return null;
    },
  };
}

/** The refusal of an edit while a moment of the past is shown. */
const LOOKED_BACK = 'A moment of the past is shown, and stays as it was: look-now shows the present.';

/** The refusal of what the open task locks. */
const KEPT = 'The task that is open keeps this as it is.';

function changeSettings(app: WorkParts & VisitParts, wish: HostSettings): Refusal {
  const problem = settingsProblem(wish);
  if (problem !== null) return problem;
  const now: Readonly<Record<string, unknown>> = { ...app.settings.current.value };
  const others = Object.entries(heldSettings(wish)).filter(([name, value]) => !isSame(value, now[name]));
  if (app.work.locks.refusesSettings(others.map(([name]) => name))) return KEPT;
  bringSettings(app, wish);
  return null;
}

/** Enters a mode, or says why it is not offered. */
function enterMode({ mode, host }: HostedPage, wished: ArenaMode): Refusal {
  mode.enter(wished);
  if (mode.current.value === wished) return null;
  if (wished === 'lookBack') return 'This needs a run that has been.';
  return host.parts.value?.includes('tools') === false ? NO_TOOLS : KEPT;
}

/** The refusal of building where the host shows no tools. */
const NO_TOOLS = 'The page shows no tools: "tools" is not among its parts.';

function bringSettings({ settings, host }: Pick<WorkParts, 'settings'> & VisitParts, wish: HostSettings): void {
  settings.hold(heldSettings(wish));
  if (wish.parts !== undefined) host.parts.value = wish.parts;
  if (wish.labels !== undefined) host.labels.value = wish.labels;
}

/** Starting, stopping, and everything in between. */
function hostRuns(
  app: Pick<RunParts, 'run' | 'hand'> & VisitParts,
): Pick<EmbeddedSimulator, 'run' | 'stop' | 'reset' | 'pause' | 'resume' | 'step'> {
  const { run, hand } = app;
  const onlyWhen = (needed: 'running' | 'paused', act: () => void): Refusal => {
    if (run.phase.value !== needed) return `This needs a run that is ${needed}; it is ${run.phase.value}.`;
    act();
    return null;
  };
  return {
    run: (paused = false) => startRun(app, paused),
    stop: () => run.stop(),
    async reset() {
      hand.reset();
      await run.reset();
    },
    pause: () => onlyWhen('running', () => run.pause()),
    resume: () =>
      onlyWhen('paused', () => {
        run.look.leave(); // what goes on is the present
        run.resume();
      }),
    step() {
      if (run.phase.value === 'stopping') return 'This needs a run that is not being stopped.';
      run.step();
      return null;
    },
  };
}

function settingsOf({
  settings: { current },
  layout,
}: Pick<WorkParts, 'settings'> & Pick<LayoutParts, 'layout'>): ReturnType<EmbeddedSimulator['settings']> {
  const { language, theme, speed, muted } = current.value;
  const { myRobot: _, ...chosen } = travelling(current.value);
  return { ...chosen, language, theme, speed, muted, parts: layout.parts.value };
}

/** Reports everything that happens in the page to `tell`. @returns ends it */
function listenTo(app: HostedPage, tell: (event: SimulatorEvent) => void): () => void {
  const { run, work, host } = app;
  const atOnce = { flush: 'sync' } as const;
  const ends = [
    host.listen(tell),
    listenToDebugger(app, tell),
    watch(run.phase, (phase) => tell({ type: 'phase', phase }), atOnce),
    watch(run.snapshot, (snapshot) => snapshot && tell({ type: 'snapshot', snapshot }), atOnce),
    watch(work.scene, (scene) => tell({ type: 'scene', scene }), atOnce),
    watch(
      () => work.work.value.project.files,
      (files) => tell({ type: 'files', files }),
      atOnce,
    ),
    watch(
      () => work.work.value.project.devices?.others,
      (now = [], before = []) => {
        for (const [at, { name, files }] of now.entries())
          if (files !== before[at]?.files) tell({ type: 'files', files, device: name });
      },
      atOnce,
    ),
    watch(
      () => JSON.stringify(settingsOf(app)),
      () => tell({ type: 'settings', settings: settingsOf(app) }),
    ),
  ];
  return () => {
    for (const end of ends) end();
  };
}
