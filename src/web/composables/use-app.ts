import { computed, inject, provide, shallowRef, watch, type InjectionKey } from 'vue';

import type { PlacedPose } from '#simulation/input';
import { AUTO, chooseHardware } from '#simulation/hardware';
import { defaultScene } from '#scene/scene';
import type { Ended } from '#simulation/simulation';

import { lastPlace, type ErrorPlace } from '../console/console-log';
import { adviceFor } from '../console/error-advice';
import { t } from '../i18n';
import { firstCourse, projectOf } from '../project/courses';
import { filesByName, MAIN } from '../project/project';
import type { Work } from '../project/history';
import type { TabStorage } from '../project/tab-storage';
import { compileFirmware } from '../worker/firmware';
import { keepWork, storedWork } from './keep-work';
import { ConsoleModel } from './use-console';
import { useDialogs, type DialogsModel } from './use-dialogs';
import { useLayout, type LayoutModel } from './use-layout';
import { useNotices, type NoticesModel } from './use-notices';
import { RunModel } from './use-run';
import { useSettings, type SettingsModel } from './use-settings';
import { WorkModel } from './use-work';

/** Everything the panels share. */
export interface App {
  readonly settings: SettingsModel;
  readonly work: WorkModel;
  readonly console: ConsoleModel;
  readonly run: RunModel;
  readonly notices: NoticesModel;
  readonly dialogs: DialogsModel;
  readonly layout: LayoutModel;
  readonly hand: Hand;
  readonly jump: Jump;
}

/** Where the hand put the robot before a run; a reset puts it back. */
export type Hand = ReturnType<typeof useHand>;

/** A wish to show a line of a file, and the line that is marked as wrong. */
export type Jump = ReturnType<typeof useJump>;

const KEY: InjectionKey<App> = Symbol('app');

/** The app's shared parts, inside any panel. */
export function useApp(): App {
  const app = inject(KEY);
  if (app === undefined) throw new Error('useApp was called outside of the app');
  return app;
}

/** Creates the app's shared parts and hands them to all panels below. */
export function provideApp(storage: TabStorage): App {
  const settings = useSettings();
  const notices = useNotices();
  const work = new WorkModel(storedWork(storage) ?? firstWork(), Date.now);
  keepWork(work, storage, () => notices.show({ kind: 'warn', key: 'files.storageFull' }));
  const console = new ConsoleModel();
  const jump = useJump(work);
  const hand = useHand();
  const layout = useLayout(settings);
  const run = createRun({ work, console, jump, hand, notices, layout });
  run.setSpeed(settings.current.value.speed);
  watch(
    () => settings.current.value.speed,
    (speed) => run.setSpeed(speed),
  );
  // Another course is another start: the run and the hand belong to the old one.
  watch(work.scene, () => {
    hand.reset();
    void run.reset();
  });
  const app: App = { settings, work, console, run, notices, dialogs: useDialogs(), layout, hand, jump };
  provide(KEY, app);
  return app;
}

function firstWork(): Work {
  const course = firstCourse();
  const empty = { files: [{ name: MAIN, text: '' }], scene: defaultScene(), course: null };
  return { project: course === undefined ? empty : projectOf(course), open: MAIN, previous: [] };
}

/** The robot and the board that a run of the present work would have; `null` for the bare board. */
export function useHardware({ work }: Pick<App, 'work'>) {
  return computed(() => {
    const chosen = chooseHardware({
      scene: work.scene.value,
      files: filesByName(work.files.value),
      robot: AUTO,
      board: AUTO,
    });
    return 'problem' in chosen ? null : chosen;
  });
}

function useHand() {
  const pose = shallowRef<PlacedPose | null>(null);
  return {
    pose,
    reset: (): void => {
      pose.value = null;
    },
  };
}

function useJump(work: WorkModel) {
  const target = shallowRef<ErrorPlace | null>(null);
  const wrong = shallowRef<ErrorPlace | null>(null);
  return {
    target,
    wrong,
    to: (place: ErrorPlace): void => {
      work.show(place.file);
      target.value = { ...place };
    },
  };
}

type RunParts = Pick<App, 'work' | 'console' | 'jump' | 'hand' | 'notices' | 'layout'>;

function createRun(parts: RunParts): RunModel {
  let runs = 0;
  const run: RunModel = new RunModel({
    createWorker: () => new Worker(new URL('../worker/worker.ts', import.meta.url), { type: 'module' }),
    firmware: compileFirmware,
    setup: () => setupOf(parts),
    onStart: () => {
      runs += 1;
      parts.jump.wrong.value = null;
      parts.notices.close();
      parts.console.startRun(runs);
    },
    onOutput: (text) => parts.console.write(text),
    onEnded: (ended) => showEnd(parts, ended, isDriving(run)),
    onFailed: (message) => parts.notices.show({ kind: 'error', key: 'notice.failed', values: { message } }),
    onUnavailable: () => parts.notices.show({ kind: 'error', key: 'notice.firmware' }),
    onKilled: () => parts.notices.show({ kind: 'warn', key: 'notice.killed' }),
  });
  watch(run.phase, (phase) => {
    if (phase === 'stopped' && run.ended.value === null) parts.console.quieten();
  });
  return run;
}

function setupOf({ work, hand }: RunParts) {
  const placed = hand.pose.value;
  return {
    scene: work.scene.value,
    files: filesByName(work.files.value),
    robot: AUTO,
    board: AUTO,
    seed: 1,
    reality: 0,
    inputs: placed === null ? [] : [{ timeUs: 0, action: { type: 'place' as const, pose: placed } }],
  };
}

/** Shows how the program ended: an exception on a card with its line, anything else in the state of the run. */
function showEnd(parts: RunParts, ended: Ended, drives: boolean): void {
  const { work, console, jump, layout, notices } = parts;
  const { exception } = ended;
  if (exception === null) {
    console.addNote(drives ? 'console.finishedDriving' : 'console.finished');
    return;
  }
  const names = work.files.value.map((file) => file.name);
  const place = lastPlace(exception.traceback, names);
  jump.wrong.value = place;
  console.addError(place, adviceFor(exception));
  if (drives) console.addNote('console.motorsOn');
  // A phone shows one pane: an error must not stay hidden behind a tab.
  if (layout.kind.value !== 'phone' || layout.tab.value === 'console') return;
  const show = (): void => void (layout.tab.value = 'console');
  const text = errorText(ended, names);
  if (text !== null) notices.show({ kind: 'error', ...text, action: { key: 'nav.console', run: show } });
}

/** Whether the motors turn: they go on when the program is over, as on the real robot. */
function isDriving(run: RunModel): boolean {
  const duty = run.snapshot.value?.robot?.state.duty;
  return duty !== undefined && (duty.left !== 0 || duty.right !== 0);
}

/** What the live region says about an error. */
export function errorSentence(ended: Ended, files: readonly string[]): string {
  const text = errorText(ended, files);
  return text === null ? '' : t(text.key, text.values);
}

function errorText({ exception }: Ended, files: readonly string[]) {
  if (exception === null) return null;
  const advice = adviceFor(exception);
  const message = t(advice.key, advice.values);
  const place = lastPlace(exception.traceback, files);
  return place === null
    ? { key: 'state.announceError' as const, values: { message } }
    : { key: 'state.announceErrorLine' as const, values: { ...place, message } };
}
