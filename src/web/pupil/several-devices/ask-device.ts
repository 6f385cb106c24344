import type { Component } from 'vue';

import { MOST_DEVICES } from '#project/devices';

import { t } from '../../kit/i18n';
import type { PageParts } from '../../kit/parts';
import type { WorkParts } from '../../session/work/model/parts';
import AddDeviceForm from './AddDeviceForm.vue';
import DeviceNameForm from './DeviceNameForm.vue';
import words from './words';

/** True if the project takes one more device. */
export const hasRoom = ({ work }: Pick<WorkParts, 'work'>): boolean => work.devices.value.length < MOST_DEVICES;

/** Asks for the kind of a new device, and adds it. */
export function askForDevice(app: Pick<PageParts, 'dialogs'> & WorkParts): void {
  if (hasRoom(app) && !app.work.staysAsItIs())
    app.dialogs.ask({ kind: 'form', title: () => t(words.addTitle), form: AddDeviceForm as Component });
}

/** Asks for another name for the device that is shown. */
export function askForName({ dialogs, work }: Pick<PageParts, 'dialogs'> & WorkParts): void {
  if (work.staysAsItIs()) return;
  const name = work.devices.value[work.place.value] ?? '';
  dialogs.ask({ kind: 'form', title: () => t(words.renameTitle, { name }), form: DeviceNameForm as Component });
}
