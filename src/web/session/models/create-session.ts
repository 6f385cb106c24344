import { watch } from 'vue';

import { projectOf } from '#catalogue/course';
import { MAIN, newWork, type Project } from '#project/project';
import { defaultScene } from '#scene/scene';

import { createDialogs } from '../../kit/dialogs';
import type { FeaturePage } from '../../kit/features/feature-page';
import type { Language } from '../../kit/i18n';
import { createNotices } from '../../kit/notices';
import { providePage } from '../../kit/parts';
import { LateModels } from '../../kit/state/late-models';
import { ArenaAlone } from '../layout/arena-alone';
import { createLayout } from '../layout/layout-model';
import { provideLayout } from '../layout/parts';
import { createRouter } from '../layout/router';
import { createMode } from '../mode/mode-model';
import { provideMode } from '../mode/parts';
import { DataLogModel } from '../run/data-log-model';
import { createHand } from '../run/hand';
import { provideRun, type RunParts } from '../run/parts';
import { SoundPlayer } from '../run/sound/sound-player';
import { provideTask } from '../task/parts';
import { createTask } from '../task/task-model';
import { heldByWish } from '../visit/held-settings';
import { HostView, type HostWish } from '../visit/host-view';
import { provideVisit } from '../visit/parts';
import { fetchNameOf, firstCourse } from '../work/catalogue/first-course';
import { deviceSettings } from '../work/hardware/hardware';
import { keepWork, type Opened } from '../work/model/keep-work';
import { provideWork, type WorkParts } from '../work/model/parts';
import { useLiveEdits } from '../work/model/use-live-edits';
import { WorkModel } from '../work/model/work-model';
import { createSettings } from '../work/settings/settings-model';
import type { Work } from '../work/storage/history';
import { pageStorage } from '../work/storage/memory-storage';
import { browserEngine, createRun, type RunEngine } from './create-run';
import { placeCard } from './place-card';
import { sayUnsaved } from './say-unsaved';
import type { SessionParts } from './session';

/**
 * Makes the models of the session and joins them.
 *
 * @param pages all pages with an address
 */
export function createSession(
  opened: Opened,
  wish: HostWish,
  pages: readonly FeaturePage[],
  engine: RunEngine = browserEngine,
): SessionParts {
  const page = { notices: createNotices(), dialogs: createDialogs(), late: new LateModels() };
  const host = new HostView(wish);
  const settings = createSettings(heldByWish(wish), (names) => locks.refusesSettings(names));
  // The stored settings are those of other work; this one begins now.
  if (opened.work === null && wish.settings.arenaSenses === undefined) settings.bring(newWork);
  const work = new WorkModel(opened.work ?? firstWork(settings.current.value.language), Date.now);
  const { locks } = work;
  work.programs = starStore(wish);
  keepWork(
    work,
    opened.storage,
    (why) => sayUnsaved({ ...page, work, settings }, why),
    (savedMs) => void import('../work/take-over').then(({ takeOver }) => takeOver({ ...page, work }, savedMs)),
  );
  const mine = { work, settings };
  const sight = { layout: createLayout(settings, host), alone: new ArenaAlone(), router: createRouter(pages) };
  const results = { hand: createHand(), dataLog: new DataLogModel(() => work.place.value), sound: new SoundPlayer() };
  const running = createRun({ ...page, ...mine, ...sight, ...results, host }, engine);
  followSettings({ ...mine, ...running });
  followCourse({ ...mine, ...running });
  const task = createTask({ ...mine, ...running }, window.parent === window, work.programs);
  const mode = createMode({ ...mine, ...running, host });
  watch(mode.current, (now) => (sight.layout.mode.value = now), { immediate: true, flush: 'sync' });
  placeCard({ ...mine, ...sight, task, mode });
  return { ...page, ...mine, ...sight, ...running, host, task, mode };
}

/** Hands each room's models to the components below. */
export function provideSession(parts: SessionParts): void {
  providePage(parts);
  provideVisit(parts);
  provideWork(parts);
  provideLayout(parts);
  provideRun(parts);
  provideTask(parts);
  provideMode(parts);
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

/** Another course is another start: the run and the hand belong to the old one. Editing it is none, and reaches the run. */
function followCourse({ work, run, hand, runStart }: Pick<WorkParts, 'work'> & RunParts): void {
  watch(
    work.openings,
    () => {
      hand.reset();
      void run.reset();
    },
    { flush: 'sync' },
  );
  useLiveEdits(run, work, hand, runStart);
}

/** The store for stars and programs of courses: none on a page that stores no work; if the browser forbids one, for this visit. */
const starStore = ({ keepsWork }: HostWish): Storage | null => (keepsWork ? pageStorage() : null);

function firstWork(language: Language): Work {
  const empty = { files: [{ name: MAIN, text: '' }], scene: defaultScene(), course: null };
  return { project: firstCourse === undefined ? empty : projectOf(firstCourse, language), open: MAIN, previous: [] };
}
