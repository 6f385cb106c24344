import { watch } from 'vue';

import { Board } from '#board/board';
import { Clock } from '#core/clock';
import type { EmbeddedSimulator, HostSettings, Refusal, SimulatorEvent } from '#embed/simulator';
import { MAIN, nameProblem, type Project, type SourceFile } from '#project/project';
import { editProblem } from '#scene/check-edit';
import type { SceneEdit } from '#scene/edit';
import type { Scene } from '#scene/scene';
import { movableIds } from '#simulation/at-once';
import type { Hardware } from '#simulation/hardware';
import type { InputAction } from '#simulation/input';
import { createInputCheck } from '#simulation/run-problem';

import { stampSettings } from '../composables/stamp-settings';
import { hardwareNow, type App } from '../composables/use-app';
import { isOurs } from '../composables/use-courses';
import { workName } from '../composables/work-name';
import { isSameWork } from '../project/history';
import { travelling } from '../project/travelling';
import { presentProject } from '../share/save-work';
import { heldSettings } from './held-settings';
import { settingsProblem } from './settings-problem';

/** The app as its host sees it. Whatever a host does goes the way that the page's own controls go. */
export function appSimulator(app: App): EmbeddedSimulator {
  const { run, host } = app;
  const change = (wish: HostSettings): Refusal => changeSettings(app, wish);
  const inputs = hostInputs(app);
  return {
    phase: () => run.phase.value,
    nowUs: () => run.nowUs.value,
    snapshot: () => run.snapshot.value,
    ended: () => run.ended.value,
    board: () => hardwareNow(app)?.board.id ?? '',
    project: () => presentProject(app),
    settings: () => settingsOf(app),
    sensorWishes: () => app.sensors.wishes.value,
    ...hostWork(app, change),
    change,
    ...hostRuns(app),
    input: (action) => inputs.take(action),
    clearConsole: () => app.console.clear(),
    onRunAsked: (ask) => void (host.ask.value = ask),
    listen: (listener) =>
      listenTo(app, (event) => {
        if (event.type !== 'sensed' || !inputs.isOwn()) listener(event);
      }),
  };
}

/** Opening and editing. */
function hostWork(
  app: App,
  change: (wish: HostSettings) => Refusal,
): Pick<EmbeddedSimulator, 'openProject' | 'setFiles' | 'setScene' | 'edit'> {
  const { run, work, host, hand } = app;
  /** What a host opened last: it has that itself, nothing of it need be put aside. */
  let brought: Project | null = null;
  /** The name under which the pupil's own work is put aside, or `null` where there is none. */
  function nameOfOwn(): string | null {
    const { project } = work.work.value;
    if (!host.wish.keepsWork || isOurs(project) || (brought !== null && isSameWork(project, brought))) return null;
    stampSettings(app);
    return workName(app);
  }
  function open(project: Project): void {
    void run.reset();
    hand.reset();
    work.openProject(project, nameOfOwn());
    brought = work.work.value.project;
  }
  return {
    openProject(project) {
      const { settings } = project;
      const problem = filesProblem(project.files) ?? (settings ? settingsProblem(settings) : null);
      if (problem !== null) return problem;
      open(project);
      return settings === undefined ? null : change(settings);
    },
    setFiles(files) {
      const problem = filesProblem(files);
      if (problem === null) open({ ...work.work.value.project, files });
      return problem;
    },
    setScene(scene: Scene) {
      open({ ...work.work.value.project, scene, course: null });
      return null;
    },
    edit(edit: SceneEdit) {
      const problem = editProblem(work.scene.value, edit);
      if (problem !== null) return problem.message;
      app.editor.commit(edit);
      return null;
    },
  };
}

function filesProblem(files: readonly SourceFile[]): Refusal {
  for (const [index, { name }] of files.entries()) {
    const others = files.filter((_, other) => other !== index);
    const problem = nameProblem(name, others);
    if (problem !== null) return `files.${index}.name: "${name}" cannot be the name of a file (${problem}).`;
  }
  return files.some(({ name }) => name === MAIN) ? null : `files: ${MAIN} is missing.`;
}

function changeSettings({ settings, host }: App, wish: HostSettings): Refusal {
  const problem = settingsProblem(wish);
  if (problem !== null) return problem;
  settings.hold(heldSettings(wish));
  if (wish.parts !== undefined) host.parts.value = wish.parts;
  if (wish.labels !== undefined) host.labels.value = wish.labels;
  return null;
}

/** Starting, stopping and what lies between. */
function hostRuns(app: App): Pick<EmbeddedSimulator, 'run' | 'stop' | 'reset' | 'pause' | 'resume' | 'step'> {
  const { run, hand } = app;
  const onlyWhen = (needed: 'running' | 'paused', act: () => void): Refusal => {
    if (run.phase.value !== needed) return `This needs a run that is ${needed}; it is ${run.phase.value}.`;
    act();
    return null;
  };
  return {
    run: (paused = false) => started(app, paused),
    stop: () => run.stop(),
    async reset() {
      hand.reset();
      await run.reset();
    },
    pause: () => onlyWhen('running', () => run.pause()),
    resume: () => onlyWhen('paused', () => run.resume()),
    step() {
      run.step();
      return null;
    },
  };
}

/** Starts the program and waits until it runs. */
function started({ run, host }: App, paused: boolean): Promise<Refusal> {
  return new Promise((resolve) => {
    let message = 'The run could not start.';
    const unlisten = host.listen((event) => {
      if (event.type === 'failed') ({ message } = event);
    });
    void run.start(paused);
    const unwatch = watch(run.phase, (phase) => {
      if (phase === 'starting') return;
      unwatch();
      unlisten(); // watchers come after the news of a failure
      resolve(phase === 'failed' || phase === 'killed' ? message : null);
    });
  });
}

/** What a host does to the run, told apart from what a person does on the page: it needs no echo. */
function hostInputs(app: App): { take(action: InputAction): Refusal; isOwn(): boolean } {
  let isOwn = false;
  return {
    isOwn: () => isOwn,
    take(action) {
      const hardware = hardwareNow(app);
      if (hardware === null) return 'The course names a board or a robot that this app does not have.';
      const problem = inputProblem(action, hardware, app.work.scene.value);
      if (problem !== null) return problem;
      isOwn = true;
      try {
        if (action.type === 'sensor' && typeof action.value === 'number') app.sensors.set(action.id, action.value);
        else app.run.input(action);
      } finally {
        isOwn = false;
      }
      return null;
    },
  };
}

/** What the run itself would say: a page without a run refuses the same. */
function inputProblem(action: InputAction, { board, firmware, robot }: Hardware, scene: Scene): Refusal {
  const check = createInputCheck(new Board(board, new Clock(), firmware), scene, robot !== null);
  return check(action, scene, movableIds(new Set(), scene, scene));
}

function settingsOf({ settings: { current }, layout }: App): ReturnType<EmbeddedSimulator['settings']> {
  const { language, theme, speed, muted } = current.value;
  return { ...travelling(current.value), language, theme, speed, muted, parts: layout.parts.value };
}

/** Everything that happens, from what the page itself watches. @returns ends it */
function listenTo(app: App, tell: (event: SimulatorEvent) => void): () => void {
  const { run, work, host } = app;
  const atOnce = { flush: 'sync' } as const;
  const ends = [
    host.listen(tell),
    watch(run.phase, (phase) => tell({ type: 'phase', phase }), atOnce),
    watch(run.snapshot, (snapshot) => snapshot && tell({ type: 'snapshot', snapshot }), atOnce),
    watch(work.scene, (scene) => tell({ type: 'scene', scene }), atOnce),
    watch(work.files, (files) => tell({ type: 'files', files }), atOnce),
    watch(
      () => JSON.stringify(settingsOf(app)),
      () => tell({ type: 'settings', settings: settingsOf(app) }),
    ),
  ];
  return () => {
    for (const end of ends) end();
  };
}
