import { shallowRef, watch, type ShallowRef } from 'vue';

import { MAIN, type Project } from '#project/project';
import { defaultScene, type Scene } from '#scene/scene';

import { ConsoleModel } from '../pupil/console/console-model';
import { createJump } from '../pupil/console/jump';
import { provideConsole, type ConsoleParts } from '../pupil/console/parts';
import { DebugSlot } from '../pupil/debug/debug-slot';
import { provideDebug } from '../pupil/debug/parts';
import { provideCourseEditor } from '../course/editor/state/parts';
import { createCourseEditor, type CourseEditorModel } from '../course/editor/state/course-editor-model';
import { createEditorPanels } from '../course/editor/state/editor-panels';
import { createGuide } from '../help/guide-model';
import { provideFirstSteps } from '../help/parts';
import { createTour } from '../help/tour-model';
import { ArenaAlone } from '../session/layout/arena-alone';
import { createRouter } from '../session/layout/router';
import { featurePages } from './features/feature-pages';
import { createLayout } from '../session/layout/layout-model';
import { provideLayout, type LayoutParts } from '../session/layout/parts';
import type { HelpEntry } from '../kit/features/feature';
import { createDialogs } from '../kit/dialogs';
import type { Language } from '../kit/i18n';
import { LateModels } from '../kit/state/late-models';
import { createNotices } from '../kit/notices';
import { providePage, type PageParts } from '../kit/parts';
import { DataLogModel } from '../session/run/data-log-model';
import { createHand } from '../session/run/hand';
import { provideRun, type RunParts } from '../session/run/parts';
import { SoundPlayer } from '../session/run/sound/sound-player';
import { heldSettings } from '../session/visit/held-settings';
import { HostView, type HostWish } from '../session/visit/host-view';
import { provideVisit } from '../session/visit/parts';
import { projectOf } from '#catalogue/course';
import { fetchNameOf, firstCourse } from '../session/work/catalogue/first-course';
import { deviceSettings } from '../session/work/hardware/hardware';
import { tableNow } from '../session/work/hardware/use-hardware';
import { keepWork, type Opened } from '../session/work/model/keep-work';
import { provideWork, type WorkParts } from '../session/work/model/parts';
import { createSettings } from '../session/work/settings/settings-model';
import type { Work } from '../session/work/storage/history';
import { provideTask } from '../session/task/parts';
import { createTask } from '../session/task/task-model';
import { useLiveEdits } from '../session/work/model/use-live-edits';
import { WorkModel } from '../session/work/model/work-model';
import { keepTask } from './keep-task';
import { tellIdleHand } from './tell-idle-hand';
import { browserEngine, createRun, type RunEngine } from './create-run';

/** The models of all rooms. */
export type AllParts = ReturnType<typeof createParts>;

/** The features' entries of the help, loaded with it. */
const contributedHelp = async (): Promise<readonly HelpEntry[]> =>
  (await import('./features/all-help-entries')).allHelpEntries;

/** Makes the models of all rooms and joins them: the only place that knows all. */
export function createParts(opened: Opened, wish: HostWish, engine: RunEngine = browserEngine) {
  const page = { notices: createNotices(), dialogs: createDialogs(), late: new LateModels() };
  const host = new HostView(wish);
  const settings = createSettings(heldSettings(wish.settings), (names) => locks.refusesSettings(names));
  const work = new WorkModel(opened.work ?? firstWork(settings.current.value.language), Date.now);
  const { locks } = work;
  work.programs = starStore(wish);
  keepWork(
    work,
    opened.storage,
    () => page.notices.show({ kind: 'error', key: 'files.storageFull' }),
    (savedMs) => void import('../session/work/take-over').then(({ takeOver }) => takeOver({ ...page, work }, savedMs)),
  );
  const mine = { work, settings };
  const firstSteps = { guide: createGuide(contributedHelp), tour: createTour() };
  const sight = {
    layout: createLayout(settings, host, firstSteps.guide.isShown),
    alone: new ArenaAlone(),
    router: createRouter(featurePages),
  };
  const shownDevice = (): number => work.place.value;
  const talk = { console: new ConsoleModel((device) => tableNow(mine, device), shownDevice), jump: createJump(work) };
  const runStart = shallowRef<Scene | null>(null);
  const results = { hand: createHand(), dataLog: new DataLogModel(shownDevice), sound: new SoundPlayer() };
  const running = createRun({ ...page, ...mine, ...sight, ...talk, ...results, host, runStart }, engine);
  followSettings({ ...mine, ...running });
  emptyConsole({ work, ...running, ...talk });
  const editor = createEditor({ ...mine, ...sight, ...running, runStart });
  keepPast({ ...page, work, ...running });
  tellIdleHand({ ...page, ...running, work, editor });
  const editing = { editor, panels: createEditorPanels({ ...mine, ...sight }) };
  keepTask({ ...page, ...mine, ...running, ...editing });
  const task = createTask({ ...mine, ...running }, window.parent === window, work.programs);
  const slot = new DebugSlot({ ...mine, ...running, engine });
  return { ...page, ...mine, ...sight, ...talk, ...running, ...editing, ...firstSteps, host, task, slot };
}

/** Hands each room's models to the components below. */
export function provideParts(parts: AllParts): void {
  providePage(parts);
  provideVisit(parts);
  provideWork(parts);
  provideLayout(parts);
  provideRun(parts);
  provideDebug(parts);
  provideConsole(parts);
  provideCourseEditor(parts);
  provideFirstSteps(parts);
  provideTask(parts);
}

/** Refuses changes of course and devices while looking back, by whichever way they come, and says so. */
function keepPast({ work, run, notices }: Pick<WorkParts, 'work'> & Pick<RunParts, 'run'> & PageParts): void {
  work.staysAsItIs = () => {
    if (run.past.value === null) return false;
    void import('../pupil/look-back/tell-past').then(({ tellPast }) => tellPast(notices));
    return true;
  };
}

/** Clears the output of another course's runs, unless the next run has already begun. */
function emptyConsole({ work, run, console }: Pick<WorkParts, 'work'> & Pick<RunParts, 'run'> & ConsoleParts): void {
  async function empty(): Promise<void> {
    await run.reset();
    if (!run.isActive.value) console.clear();
  }
  watch(work.openings, () => void empty(), { flush: 'sync' });
}

/** Passes the settings on to the run, and loads the open course's name. */
function followSettings({ settings, work, run }: WorkParts & Pick<RunParts, 'run'>): void {
  run.setSpeed(settings.current.value.speed);
  watch(
    () => settings.current.value.speed,
    (speed) => run.setSpeed(speed),
  );
  watch(
    () => settings.current.value.arenaSenses,
    (on) => {
      for (const place of work.devices.value.keys()) run.input({ type: 'arena-senses', on }, place);
    },
  );
  // Another device is another start. At once: a host that chooses one and starts must not be stopped by it afterwards.
  watch(
    () => JSON.stringify([deviceSettings(settings.current.value), devicesOf(work.work.value.project)]),
    () => void run.reset(),
    { flush: 'sync' },
  );
  watch(
    () => work.work.value.project.course,
    // Without a connection the course is called as in its file.
    (id) => void fetchNameOf(id).catch(() => undefined),
    { immediate: true },
  );
}

/** The properties of further devices that require a restart: everything except their code. */
const devicesOf = ({ devices }: Project): unknown =>
  devices && [devices.first, devices.others.map(({ files: _, ...device }) => device)];

/** The course editor beside the run. */
function createEditor(
  parts: WorkParts &
    Pick<RunParts, 'run' | 'hand'> &
    Pick<LayoutParts, 'layout'> & { readonly runStart: ShallowRef<Scene | null> },
): CourseEditorModel {
  const { settings, work, run, hand, layout, runStart } = parts;
  // Another course is another start: the run and the hand belong to the old one. Editing it is none.
  watch(
    work.openings,
    () => {
      hand.reset();
      void run.reset();
    },
    { flush: 'sync' },
  );
  useLiveEdits(run, work, hand, runStart);
  return createCourseEditor({ work, settings, kind: layout.kind, runStart, isActive: run.isActive, past: run.past });
}

/** The store for stars and programs of courses: none on a page that stores no work, or if the browser forbids it. */
function starStore({ keepsWork }: HostWish): Storage | null {
  try {
    return keepsWork ? localStorage : null;
  } catch {
    return null;
  }
}

function firstWork(language: Language): Work {
  const empty = { files: [{ name: MAIN, text: '' }], scene: defaultScene(), course: null };
  return { project: firstCourse === undefined ? empty : projectOf(firstCourse, language), open: MAIN, previous: [] };
}
