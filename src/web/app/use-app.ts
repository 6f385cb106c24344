import { computed, inject, provide, shallowRef, watch, type InjectionKey, type ShallowRef } from 'vue';

import { filesByName, MAIN, type SourceFile } from '#project/project';
import type { InputEvent } from '#simulation/input';
import { defaultScene, type Scene } from '#scene/scene';
import type { RunSetup } from '#simulation/run-setup';
import type { Ended } from '#simulation/simulation';

import { lastPlace, type ErrorPlace } from '../console/log/console-log';
import { explain, fetchAdvice } from '../console/advice/explain';
import { movesBodies } from '../course-editor/state/waiting';
import { HostView, type HostWish } from '../visit/host-view';
import { heldSettings } from '../visit/held-settings';
import { t, type Language } from '../page/i18n';
import { projectOf } from '../work/catalogue/course';
import { boardWish } from '../work/settings/devices';
import { fetchNameOf, firstCourse } from '../work/catalogue/first-course';
import { deviceSettings, hardwareOf, seedOf } from '../work/hardware/hardware';
import type { Work } from '../work/storage/history';
import type { TabStorage } from '../work/storage/tab-storage';
import { SoundPlayer } from '../run/sound/sound-player';
import { createWorker } from '../run/worker/create-worker';
import { compileFirmware } from '../run/worker/firmware';
import { keepWork, storedWork } from '../work/keep-work';
import { fittingInputs } from '../run/fitting-inputs';
import { mispluggedNotice, tableOf } from '../work/hardware/misplugged';
import { ConsoleModel } from '../console/use-console';
import { useCourseEditor, type CourseEditorModel } from '../course-editor/state/use-course-editor';
import { DataLogModel } from '../run/use-data-log';
import { useDialogs, type DialogsModel } from '../page/use-dialogs';
import { useGallery, type GalleryModel } from '../galleries/use-gallery';
import { useHand, type Hand } from '../arena/use-hand';
import { useJump, type Jump } from '../console/use-jump';
import { useLayout, type LayoutModel } from '../layout/use-layout';
import { useLiveEdits } from '../work/use-live-edits';
import { useNotices, type NoticesModel } from '../page/use-notices';
import { RadioModel } from '../run/use-radio';
import { RunModel, type RunHost } from '../run/use-run';
import { SensorsModel } from '../run/use-sensors';
import { useSettings, type SettingsModel } from '../work/settings/use-settings';
import { WorkModel } from '../work/use-work';

/** Everything the panels share. */
export interface App {
  readonly settings: SettingsModel;
  readonly work: WorkModel;
  readonly console: ConsoleModel;
  readonly run: RunModel;
  readonly sensors: SensorsModel;
  readonly radio: RadioModel;
  readonly dataLog: DataLogModel;
  readonly sound: SoundPlayer;
  readonly notices: NoticesModel;
  readonly dialogs: DialogsModel;
  readonly gallery: GalleryModel;
  readonly layout: LayoutModel;
  readonly hand: Hand;
  readonly jump: Jump;
  readonly editor: CourseEditorModel;
  readonly host: HostView;
}

/** How long after the start of the first run the page fetches what explains errors, in ms. */
const ADVICE_AFTER_MS = 2000; // chosen: the robot drives by then; an error before that fetches it at once

const KEY: InjectionKey<App> = Symbol('app');

/** The app's shared parts, inside any panel. */
export function useApp(): App {
  const app = inject(KEY);
  if (app === undefined) throw new Error('useApp was called outside of the app');
  return app;
}

/** Creates the app's shared parts and hands them to all panels below. */
export function provideApp(storage: TabStorage, wish: HostWish): App {
  const host = new HostView(wish);
  const settings = useSettings(heldSettings(wish.settings));
  const notices = useNotices();
  const work = new WorkModel(storedWork(storage) ?? firstWork(settings.current.value.language), Date.now);
  keepWork(work, storage, () => notices.show({ kind: 'warn', key: 'files.storageFull' }));
  const console = new ConsoleModel(() => tableNow({ work, settings }));
  const jump = useJump(work);
  const hand = useHand();
  const layout = useLayout(settings, host);
  const dataLog = new DataLogModel();
  const runStart = shallowRef<Scene | null>(null);
  const sound = new SoundPlayer();
  const parts: RunParts = { settings, work, console, jump, hand, notices, layout, dataLog, sound, host, runStart };
  const { run, sensors, radio } = createRun(parts);
  run.setSpeed(settings.current.value.speed);
  watch(
    () => settings.current.value.speed,
    (speed) => run.setSpeed(speed),
  );
  watch(
    () => work.work.value.project.course,
    // Without a connection the course is called as in its file.
    (id) => void fetchNameOf(id).catch(() => undefined),
    { immediate: true },
  );
  const editor = createEditor(parts, run);
  // Another device is another start. At once: a host that chooses one and starts must not be stopped by it afterwards.
  watch(
    () => deviceKey(settings),
    () => void run.reset(),
    { flush: 'sync' },
  );
  watch(
    () => settings.current.value.arenaSenses,
    (on) => run.input({ type: 'arena-senses', on }),
  );
  const app: App = { ...parts, run, sensors, radio, editor, dialogs: useDialogs(), gallery: useGallery() };
  provide(KEY, app);
  return app;
}

/** The course editor beside the run. */
function createEditor({ settings, work, hand, layout, runStart }: RunParts, run: RunModel): CourseEditorModel {
  // Another course is another start: the run and the hand belong to the old one. Editing it is none.
  watch(
    work.openings,
    () => {
      hand.reset();
      void run.reset();
    },
    { flush: 'sync' },
  );
  useLiveEdits(run, work, runStart);
  return useCourseEditor({
    work,
    settings,
    kind: layout.kind,
    runStart,
    isActive: run.isActive,
    onEdit: (before, after) => {
      hand.letGo(before, after);
      // The last picture of a stopped run would hide what was changed.
      const isOver = !run.isActive.value && run.snapshot.value !== null;
      if (isOver && movesBodies(before, after)) void run.reset();
    },
  });
}

function firstWork(language: Language): Work {
  const empty = { files: [{ name: MAIN, text: '' }], scene: defaultScene(), course: null };
  return { project: firstCourse === undefined ? empty : projectOf(firstCourse, language), open: MAIN, previous: [] };
}

/** What every Run button does: the program runs, or a host that brings the program first is asked for it. */
export function pressRun({ run, host }: Pick<App, 'run' | 'host'>): void {
  if (host.ask.value === null) void run.start();
  else host.ask.value();
}

/** The robot, the board and its firmware that a run of the present work would have; `null` where the course names unknown ones. */
export function useHardware(app: Pick<App, 'work' | 'settings'>) {
  return computed(() => hardwareNow(app));
}

/** The same at this moment. */
export const hardwareNow = ({ work: { work }, settings }: Pick<App, 'work' | 'settings'>) =>
  hardwareOf(work.value.project, settings.current.value);

const tableNow = ({ work: { work }, settings }: Pick<App, 'work' | 'settings'>) =>
  tableOf(work.value.project, settings.current.value);

const deviceKey = ({ current }: SettingsModel): string => JSON.stringify(deviceSettings(current.value));

type RunParts = Omit<App, 'run' | 'sensors' | 'radio' | 'dialogs' | 'gallery' | 'editor'> & {
  /** The course that the run was given. */
  readonly runStart: ShallowRef<Scene | null>;
};

/** The run, and what reaches into it. */
function createRun(parts: RunParts): Pick<App, 'run' | 'sensors' | 'radio'> {
  let runs = 0;
  const run: RunModel = new RunModel({
    createWorker,
    firmware: compileFirmware,
    setup: () => {
      const setup = setupOf(parts, sensors.startInputs());
      parts.runStart.value = setup.scene;
      return setup;
    },
    onInput: (action) => {
      const { type } = action;
      if (type === 'button' || type === 'touch' || type === 'sensor') parts.host.tell({ type: 'sensed', action });
    },
    onStart: () => {
      runs += 1;
      parts.host.tell({ type: 'started' });
      parts.jump.wrong.value = null;
      showStart(parts);
      parts.console.startRun(runs);
      if (runs === 1) setTimeout(() => void fetchAdvice(), ADVICE_AFTER_MS);
      parts.dataLog.clear();
      radio.clear();
    },
    onOutput: (text) => {
      parts.console.write(text);
      parts.host.tell({ type: 'output', text });
    },
    onEnded: (ended) => {
      showEnd(parts, ended, run);
      parts.host.tell({ type: 'program-ended', ended, verdict: run.snapshot.value?.verdict ?? null });
    },
    onRestarted: () => {
      parts.host.tell({ type: 'program-restarted' });
      parts.jump.wrong.value = null;
      parts.notices.close();
    },
    onEvents: (events) => {
      radio.take(events.radio, events.radioDropped);
      parts.dataLog.take(events.log);
      parts.sound.take(events.sound);
      if (events.radio.length > 0)
        parts.host.tell({ type: 'radio', packets: events.radio, dropped: events.radioDropped });
      if (events.log.length > 0) parts.host.tell({ type: 'log', events: events.log });
    },
    ...troubles(parts),
  });
  const sensors = new SensorsModel(run);
  const radio = new RadioModel(run);
  // At once: a reset leaves this phase in the same breath.
  watch(
    run.phase,
    (phase) => {
      if (phase === 'stopped') parts.console.addNote('console.stopped');
    },
    { flush: 'sync' },
  );
  return { run, sensors, radio };
}

/** What is said when a run goes wrong through no fault of the program. */
function troubles(parts: RunParts): Pick<RunHost, 'onFailed' | 'onRefused' | 'onUnavailable' | 'onKilled'> {
  const { notices, host } = parts;
  return {
    onFailed: (message) => {
      void showFailure(parts, message);
      host.tell({ type: 'failed', message });
    },
    onRefused: (message) => {
      notices.show({ kind: 'info', key: 'notice.refused', values: { message } });
      host.tell({ type: 'refused', message });
    },
    onUnavailable: () => {
      notices.show({ kind: 'error', key: 'notice.firmware' });
      host.tell({ type: 'failed', message: 'A part of the simulator could not be fetched.' });
    },
    onKilled: () => notices.show({ kind: 'warn', key: 'notice.killed' }),
  };
}

function setupOf({ work, hand, settings }: RunParts, sensed: readonly InputEvent[]): RunSetup {
  const hardware = hardwareNow({ work, settings });
  const { device, robot, reality, arenaSenses } = settings.current.value;
  const placed = hand.pose.value;
  const inputs: InputEvent[] = hardware === null ? [] : fittingInputs(sensed, hardware.board);
  if (hardware !== null && hardware.robot !== null) {
    if (placed !== null) inputs.push({ timeUs: 0, action: { type: 'place', pose: placed } });
    if (arenaSenses) inputs.push({ timeUs: 0, action: { type: 'arena-senses', on: true } });
  }
  const pushable = new Set(work.scene.value.objects.filter(({ type }) => type === 'block').map(({ id }) => id));
  for (const [id, pose] of Object.entries(hand.blocks.value)) {
    if (pushable.has(id)) inputs.push({ timeUs: 0, action: { type: 'place-block', id, pose } });
  }
  return {
    scene: work.scene.value,
    files: filesByName(work.files.value),
    robot,
    board: boardWish(device),
    firmware: hardware?.firmware.id ?? '',
    repl: 'at-once',
    seed: seedOf(settings.current.value),
    robotOptions: hardware?.options ?? {},
    reality,
    inputs,
  };
}

/** A robot on the wrong board is told in the arena; where that is not in sight, at the foot of the page. */
function showStart({ settings, work, layout, notices }: RunParts): void {
  const notice = layout.isShown.value.arena
    ? null
    : mispluggedNotice(work.work.value.project, settings.current.value, (wish) => settings.change(wish));
  if (notice === null) notices.close();
  else notices.show(notice);
}

/** What measures a course is fetched only when a run could not begin. */
async function showFailure(parts: RunParts, message: string): Promise<void> {
  const { work, notices } = parts;
  const [hardware, scene] = [hardwareNow(parts), work.scene.value];
  try {
    const { failureNotice } = await import('../run/failure-notice');
    notices.show(failureNotice(message, hardware, scene));
  } catch {
    notices.show({ kind: 'error', key: 'notice.failed', values: { message } });
  }
}

/** Shows how the program ended: an exception on a card with its line, anything else in the state of the run. */
function showEnd(parts: RunParts, ended: Ended, run: RunModel): void {
  const { work, console, jump, layout, notices } = parts;
  const { exception, kind } = ended;
  const drives = isDriving(run);
  if (kind === 'stopped') {
    console.quieten(); // the pupil wanted it: nothing is wrong
    console.addNote(drives ? 'console.interruptedDriving' : 'console.interrupted');
    return;
  }
  if (kind === 'panic') {
    console.addNote('console.panic');
    return;
  }
  if (exception === null) {
    console.addNote(drives ? 'console.finishedDriving' : 'console.finished');
    return;
  }
  const files = work.files.value;
  const place = placeIn(exception.traceback, files);
  jump.wrong.value = place;
  console.addError(place, { failure: exception, source: sourceAt(place, files), table: tableNow(parts) });
  if (drives) console.addNote('console.motorsOn');
  // A phone shows one pane: an error must not stay hidden behind a tab. Where a host has no console here, it shows its own.
  if (layout.kind.value !== 'phone' || layout.isShown.value.console || !layout.tabs.value.includes('console')) return;
  const show = (): void => void (layout.tab.value = 'console');
  void fetchAdvice().then(() => {
    const text = errorText(ended, parts);
    if (text !== null && run.ended.value === ended)
      notices.show({ kind: 'error', ...text, action: { key: 'nav.console', run: show } });
  });
}

/** Whether the motors turn: they go on when the program is over, as on the real robot. */
function isDriving(run: RunModel): boolean {
  const duty = run.snapshot.value?.robot?.state.duty;
  return duty !== undefined && (duty.left !== 0 || duty.right !== 0);
}

/** What the live region says about an error. */
export function errorSentence(ended: Ended, app: Pick<App, 'work' | 'settings'>): string {
  const text = errorText(ended, app);
  return text === null ? '' : t(text.key, text.values);
}

function errorText({ exception }: Ended, app: Pick<App, 'work' | 'settings'>) {
  if (exception === null) return null;
  const files = app.work.files.value;
  const place = placeIn(exception.traceback, files);
  const advice = explain({ failure: exception, source: sourceAt(place, files), table: tableNow(app) });
  const message = t(advice.key, advice.values);
  return place === null
    ? { key: 'state.announceError' as const, values: { message } }
    : { key: 'state.announceErrorLine' as const, values: { ...place, message } };
}

const placeIn = (traceback: string, files: readonly SourceFile[]): ErrorPlace | null =>
  lastPlace(
    traceback,
    files.map(({ name }) => name),
  );

/** The line that an error names, for those that are explained by what is written there. */
function sourceAt(place: ErrorPlace | null, files: readonly SourceFile[]) {
  const file = files.find(({ name }) => name === place?.file);
  return place === null || file === undefined ? null : { text: file.text, line: place.line };
}
