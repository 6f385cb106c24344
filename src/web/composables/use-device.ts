import { computed, type ComputedRef } from 'vue';

import type { Hardware } from '#simulation/hardware';
import { NO_ROBOT } from '#simulation/hardware';

import { AUTO_ROBOT, deviceName } from '../project/devices';
import type { Settings } from '../project/settings';
import { useHardware, type App } from './use-app';

/** Choosing what the program runs on. */
export interface DeviceModel {
  readonly hardware: ComputedRef<Hardware | null>;
  /** What the microcomputer is called, as it was chosen. */
  readonly name: ComputedRef<string>;
  readonly chooseDevice: (id: string) => void;
  readonly chooseFirmware: (id: string) => void;
  /** The bare board needs no arena; a robot brings it back. */
  readonly chooseRobot: (id: string) => void;
  /** A course has a robot, whatever was chosen for the programs without one. */
  readonly allowRobot: () => void;
}

export function useDevice(app: Pick<App, 'work' | 'settings' | 'run' | 'notices'>): DeviceModel {
  const { settings, run, notices } = app;
  const hardware = useHardware(app);
  /** Another device ends the run: that must not look like an accident. */
  function change(wish: Partial<Settings>): void {
    const now = settings.current.value;
    const isOther = (['device', 'firmware', 'robot'] as const).some((key) => (wish[key] ?? now[key]) !== now[key]);
    if (isOther && run.isActive.value) notices.show({ kind: 'info', key: 'notice.deviceChanged' });
    settings.change(wish);
  }
  function chooseRobot(robot: string): void {
    const before = settings.current.value.robot;
    if (robot === before) return;
    const changesArena = robot === NO_ROBOT || before === NO_ROBOT;
    change({ robot, ...(changesArena && { showArena: robot !== NO_ROBOT }) });
  }
  return {
    hardware,
    name: computed(() => deviceName(settings.current.value.device, hardware.value?.board)),
    chooseDevice: (device) => change({ device }),
    chooseFirmware: (firmware) => change({ firmware }),
    chooseRobot,
    allowRobot: () => {
      if (settings.current.value.robot === NO_ROBOT) chooseRobot(AUTO_ROBOT);
    },
  };
}
