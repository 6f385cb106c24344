/** Devices that come and go: each change can be taken back, from the message that tells of it. */
import { deviceNames, furtherDevice } from '#project/devices';
import type { FurtherDevice } from '#project/project';

import { t } from '../../kit/i18n';
import type { Workplace } from '../../session/work/model/parts';
import { workName } from '../../session/work/work-name';
import { firstName } from './new-device';
import words from './words';

/** Adds a device and shows it. A run that it ends is named. */
export function addDevice(app: Workplace, device: FurtherDevice): void {
  const { work, notices, run } = app;
  const [openings, place, ends] = [work.openings.value, work.devices.value.length, run.phase.value !== 'ready'];
  work.addDevice(device, firstName(app));
  const isThere = (): boolean => work.devices.value[place] === device.name && work.openings.value === openings;
  if (!isThere()) return; // it was refused, which was said
  function undo(): void {
    const isUntouched = furtherDevice(work.work.value.project, place) === device;
    work.removeDevice(place, isUntouched ? null : workName(app));
  }
  const text = t(ends ? words.addedEnds : words.added, { name: device.name });
  notices.show({
    ...{ kind: 'ok', key: 'notice.text', values: { text } },
    action: { key: 'notice.undo', run: undo },
    holds: isThere,
  });
}

/** Takes the device that is shown away, after putting the whole work aside. */
export function removeDevice(app: Workplace): void {
  const { work, notices } = app;
  const { project } = work.work.value;
  const [openings, place, first = ''] = [work.openings.value, work.place.value, ...deviceNames(project)];
  const device = furtherDevice(project, place);
  if (device === null || !work.removeDevice(place, workName(app))) return;
  const left = work.devices.value.length;
  const text = t(words.removed, { name: device.name });
  notices.show({
    ...{ kind: 'ok', key: 'notice.text', values: { text } },
    action: { key: 'notice.undo', run: () => work.putDeviceBack(device, place, first) },
    holds: () => work.devices.value.length === left && work.openings.value === openings,
  });
}
