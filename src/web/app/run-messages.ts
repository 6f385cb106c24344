import { filesOfDevice } from '#project/devices';
import type { Ended } from '#simulation/simulation';

import { placeIn, sourceAt } from '../pupil/console/error-text';
import type { ConsoleParts } from '../pupil/console/parts';
import type { LayoutParts } from '../session/layout/parts';
import type { PageParts } from '../kit/parts';
import type { RunModel } from '../session/run/run-model';
import { mispluggedNotice } from '../session/work/hardware/misplugged';
import { hardwareNow, tableNow } from '../session/work/hardware/use-hardware';
import type { WorkParts } from '../session/work/model/parts';

/** The models that show a run's messages. */
export type RunMessages = WorkParts & ConsoleParts & Pick<PageParts, 'notices'> & Pick<LayoutParts, 'layout'>;

/**
 * Shows a notice about a robot that does not fit board or program if the arena, which says so itself, is not in sight;
 * otherwise closes the notice.
 */
export function showStart({ settings, work, layout, notices }: RunMessages): void {
  const notice = layout.isShown.value.arena
    ? null
    : mispluggedNotice(work.work.value.project, settings.current.value, (wish) => settings.change(wish));
  if (notice === null) notices.close();
  else notices.show(notice);
}

/** Shows why a run could not begin. The code that measures a course is loaded only then. */
export async function showFailure(parts: RunMessages, message: string): Promise<void> {
  const { work, notices } = parts;
  const [hardware, scene] = [hardwareNow(parts), work.scene.value];
  try {
    const { failureNotice } = await import('../session/run/failure-notice');
    notices.show(failureNotice(message, hardware, scene));
  } catch {
    notices.show({ kind: 'error', key: 'notice.failed', values: { message } });
  }
}

/** Shows how the program ended: an exception on a card with its line, anything else as a note in the console. */
export function showEnd(parts: RunMessages, ended: Ended, run: RunModel, device: number): void {
  const { work, console, jump } = parts;
  const { exception, kind } = ended;
  const drives = isDriving(run, device);
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
  const files = filesOfDevice(work.work.value.project, device);
  const place = placeIn(exception.traceback, files);
  jump.wrong.value = place === null ? null : { ...place, device };
  console.addError(
    place,
    { failure: exception, source: sourceAt(place, files), table: tableNow(parts, device) },
    device,
  );
  if (drives) console.addNote('console.motorsOn', device);
  if (device === run.device) console.isTogether.value = false; // the explanation is there
  if (device === run.device && isHidden(parts))
    void import('./error-on-phone').then(
      ({ showErrorOnPhone }) => showErrorOnPhone(parts, ended, run),
      () => undefined, // without a connection it stands in the console alone
    );
}

/** True if an error would stay hidden behind a tab of a phone. Where a host has no console here, it shows its own. */
const isHidden = ({ layout }: RunMessages): boolean =>
  layout.kind.value === 'phone' && !layout.isShown.value.console && layout.tabs.value.includes('console');

/** True if the motors turn: they go on when the program is over, as on the real robot. */
function isDriving(run: RunModel, device: number): boolean {
  const duty = run.deviceNow(device)?.robot?.state.duty;
  return duty !== undefined && (duty.left !== 0 || duty.right !== 0);
}
