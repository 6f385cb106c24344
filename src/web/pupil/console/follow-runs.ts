import { watch } from 'vue';

import { filesOfDevice } from '#project/devices';
import type { SourceFile } from '#project/project';
import type { Ended } from '#simulation/simulation';

import type { PageParts } from '../../kit/parts';
import type { LayoutParts } from '../../session/layout/parts';
import type { RunParts } from '../../session/run/parts';
import { mispluggedNotice } from '../../session/work/hardware/misplugged';
import { fittedNow, robotInErrorNow } from '../../session/work/hardware/use-hardware';
import type { WorkParts } from '../../session/work/model/parts';
import { fetchAdvice } from './advice/explain';
import type { ErrorReport } from './advice/error-advice';
import { causeOf, isUnread, placeIn, sourceAt } from './error-text';
import type { DevicePlace } from './jump';
import type { ConsoleParts } from './parts';
import { isDriving } from './stirs';

/** Time from the start of the first run until the page fetches what explains errors, in ms. */
const ADVICE_AFTER_MS = 2000; // chosen: the robot drives by then; an error before that fetches it at once

/** The models that show what comes out of a run in words. */
type Around = WorkParts &
  ConsoleParts &
  Pick<PageParts, 'notices'> &
  Pick<LayoutParts, 'layout'> &
  Pick<RunParts, 'run' | 'listeners'>;

/** Writes what runs print into the console, and how they end. */
export function followRuns(around: Around): void {
  const { run, work, console, jump, listeners } = around;
  let runs = 0;
  listeners.push({
    onStart: () => {
      runs += 1;
      jump.wrong.value = null;
      console.startRun(runs, work.devices.value.length);
      for (const place of work.devices.value.keys())
        if (mispluggedNotice(fittedNow(around, place), () => undefined) !== null) console.addFit(place);
      if (runs === 1) setTimeout(() => void fetchAdvice(), ADVICE_AFTER_MS);
    },
    onRestarted: () => (jump.wrong.value = null),
    onOutput: ({ text, device, timeUs }) => console.write(text, device, timeUs),
    onEnded: (ended, device) => showEnd(around, ended, device),
  });
  // At once: a reset leaves this phase in the same breath.
  watch(
    run.phase,
    (phase) => {
      if (phase === 'stopped') console.addNote('console.stopped');
    },
    { flush: 'sync' },
  );
}

/** Clears the output of another course's runs, unless the next run has already begun. */
export function emptyConsole({ work, run, console }: Pick<Around, 'work' | 'run' | 'console'>): void {
  async function empty(): Promise<void> {
    await run.reset();
    if (!run.isActive.value) console.clear();
  }
  watch(work.openings, () => void empty(), { flush: 'sync' });
}

/** Shows how the program ended: an exception on a card with its line, anything else as a note in the console. */
function showEnd(parts: Around, ended: Ended, device: number): void {
  const { run, console, jump } = parts;
  const { exception, kind } = ended;
  const drives = isDriving(run.deviceNow(device));
  if (kind === 'stopped') {
    console.quieten(device); // the pupil wanted it: nothing is wrong
    console.addNote(drives ? 'console.interruptedDriving' : 'console.interrupted', device);
    return;
  }
  if (kind === 'panic') {
    console.addNote('console.panic', device);
    return;
  }
  if (exception === null) {
    console.addNote(drives ? 'console.finishedDriving' : 'console.finished', device);
    return;
  }
  const files = filesThatRan(parts, device);
  const place = placeIn(exception.traceback, files);
  const report = { failure: exception, source: sourceAt(place, files), table: robotInErrorNow(parts, device) };
  mark(jump, place === null ? null : { ...place, device }, report);
  console.addError(place, report, device);
  if (drives) console.addNote('console.motorsOn', device);
  if (device === run.device) console.isTogether.value = false; // the explanation is there
  if (device === run.device && isHidden(parts))
    void import('./error-on-phone').then(
      ({ showErrorOnPhone }) => showErrorOnPhone(parts, ended, run),
      () => undefined, // without a connection it stands in the console alone
    );
}

/** The files of a device as the run has them: the error is in them, whatever has been written since. */
function filesThatRan({ run, work }: Pick<Around, 'run' | 'work'>, device: number): readonly SourceFile[] {
  const ran = run.recording.value.setup?.devices[device]?.files;
  return filesOfDevice(work.work.value.project, device).map(({ name, text }) => ({ name, text: ran?.[name] ?? text }));
}

/** Marks the line of an error, or that of its cause once the page knows it. */
function mark(jump: ConsoleParts['jump'], place: DevicePlace | null, report: ErrorReport): void {
  jump.wrong.value = place;
  if (place === null || !isUnread(report)) return;
  void fetchAdvice().then(() => {
    if (jump.wrong.value === place) jump.wrong.value = { ...place, ...causeOf(report, place) };
  });
}

/** True if an error would stay hidden behind a tab of a phone: it stands below the program and below the arena. */
const isHidden = ({ layout: { kind, tabs, isShown } }: Around): boolean =>
  kind.value === 'phone' &&
  tabs.value.includes('console') &&
  !(['console', 'code', 'arena'] as const).some((pane) => isShown.value[pane]);
