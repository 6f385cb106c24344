import { computed, type ComputedRef } from 'vue';

import type { OptionValues } from '#core/option';
import { furtherDevice } from '#project/devices';
import type { FurtherDevice, HardwareWish } from '#project/project';
import { IN_HAND } from '#robots/in-hand';
import type { RobotType } from '#robots/robot';
import type { Hardware } from '#simulation/hardware';
import { NO_ROBOT } from '#simulation/run-setup';

import { AUTO_ROBOT, deviceName } from '../settings/devices';
import { deviceSettings, settingsFor, startOptions, withCourseOptions, withOption, withOptions } from './hardware';
import { isSeed, LAST_SEED, type Settings } from '../settings/settings';
import { mispluggedNotice, robotOffer, type FitNotice } from './misplugged';
import { fittedNow, useHardware } from './use-hardware';
import type { Workplace } from '../model/parts';
import type { Notice } from '../../../kit/notices';

/** The choice of the hardware that the program runs on. */
export interface DeviceModel {
  readonly hardware: ComputedRef<Hardware | null>;
  /** The choice for the device that is shown. */
  readonly chosen: ComputedRef<HardwareWish>;
  /** Name of the microcomputer, as it was chosen. */
  readonly name: ComputedRef<string>;
  readonly chooseDevice: (id: string) => void;
  readonly chooseFirmware: (id: string) => void;
  /** Chooses a robot. For the first device the arena is hidden with `none`, and shown again with a robot. */
  readonly chooseRobot: (id: string) => void;
  /** Ends the choice of no robot: a course has one. */
  readonly allowRobot: () => void;
  /** The open program came with this robot: it, its board and these options are chosen, as far as they are not already. */
  readonly bringRobot: (robot: RobotType, options?: OptionValues) => void;
  /** The open course came with its robot set up: that holds, whatever was changed before. */
  readonly setUpForCourse: () => void;
  /** The options of the robot in use before anything is changed by hand. */
  readonly startOptions: ComputedRef<OptionValues>;
  readonly chooseOption: (option: string, choice: string) => void;
  readonly resetOptions: () => void;
  /** Plugs a board without a robot into a thing that is held in the hand, by its choice (`#robots/in-hand`); `null`: into none. */
  readonly chooseInHand: (choice: string | null) => void;
  readonly chooseReality: (reality: number) => void;
  /** Takes the used robot with this number; an invalid number changes nothing. */
  readonly chooseSeed: (seed: number) => void;
  /** Takes the used robot with the next number, after the last the first. */
  readonly nextSeed: () => void;
  /** The mismatch of robot and board, or of robot and program, with a remedy; otherwise `null`. */
  readonly misplugged: ComputedRef<FitNotice | null>;
  /** The remedy for an error of a robot that does not fit, or of none; `null`: there is none, or a task keeps the robot. */
  readonly offer: ComputedRef<Notice['action'] | null>;
}

type Parts = Workplace;

export function useDevice(app: Parts): DeviceModel {
  const { settings, work } = app;
  const hardware = useHardware(app);
  const change = changing(app);
  const further = (): FurtherDevice | null => furtherDevice(work.work.value.project, work.place.value);
  const now = (): Settings => ({ ...settings.current.value, ...wishOf(further()) });
  /** Changes options of the robot in use, if there is one: in the pupil's own choice and in what holds now. */
  function changeRobot(wish: (settings: Settings, robot: RobotType) => Partial<Settings>): void {
    const robot = hardware.value?.robot ?? null;
    if (robot !== null) change(wish(now(), robot), wish({ ...settings.own.value, ...wishOf(further()) }, robot));
  }
  return {
    hardware,
    chosen: computed(() => now()),
    name: computed(() => deviceName(now().device, hardware.value?.board)),
    chooseDevice: (device) => change({ device }),
    chooseFirmware: (firmware) => change({ firmware }),
    chooseRobot: (robot) => change({ robot, ...(further() === null && arenaFor(robot, now())) }),
    ...useBringing(app, hardware),
    startOptions: computed(() => {
      const robot = hardware.value?.robot ?? null;
      return robot === null ? {} : startOptions(robot, work.scene.value);
    }),
    chooseOption: (option, choice) =>
      changeRobot((before, robot) => withOption(before, robot, work.scene.value, [option, choice])),
    resetOptions: () => changeRobot((before, robot) => withOptions(before, robot, [])),
    chooseInHand: (choice) => {
      const inHand = ({ robotOptions: { [NO_ROBOT]: _before, ...others } }: Settings): Partial<Settings> => ({
        robotOptions: choice === null ? others : { ...others, [NO_ROBOT]: { [IN_HAND]: choice } },
      });
      change(inHand(now()), inHand({ ...settings.own.value, ...wishOf(further()) }));
    },
    chooseReality: (reality) => change({ reality }),
    chooseSeed: (seed) => {
      if (isSeed(seed)) change({ seed });
    },
    nextSeed: () => change({ seed: (now().seed % LAST_SEED) + 1 }),
    misplugged: computed(() => mispluggedNotice(fittedNow(app), change)),
    offer: computed(() =>
      robotOffer(fittedNow(app), (wish) =>
        change({ ...wish, ...(further() === null && arenaFor(wish.robot ?? '', now())) }),
      ),
    ),
  };
}

/** Adapts the choice when a program or a course is opened. The change is plain to see, so there is no notice. */
function useBringing(
  { settings, work }: Parts,
  hardware: ComputedRef<Hardware | null>,
): Pick<DeviceModel, 'allowRobot' | 'bringRobot' | 'setUpForCourse'> {
  function changeBoth(wish: (before: Settings) => Partial<Settings>): void {
    settings.bring(wish(settings.current.value), wish(settings.own.value));
  }
  function choose(wish: Pick<Settings, 'robot'> & Partial<Settings>): void {
    settings.bring({ ...wish, ...arenaFor(wish.robot, settings.current.value) });
  }
  return {
    allowRobot: () => {
      if (settings.current.value.robot === NO_ROBOT) choose({ robot: AUTO_ROBOT });
    },
    bringRobot: (robot, options = {}) => {
      choose(settingsFor(robot, work.work.value.project, settings.current.value));
      for (const chosen of Object.entries(options))
        changeBoth((before) => withOption(before, robot, work.scene.value, chosen));
    },
    setUpForCourse: () => {
      const robot = hardware.value?.robot ?? null;
      if (robot !== null) changeBoth((before) => withCourseOptions(before, robot, work.scene.value));
    },
  };
}

/** The setting that hides the arena with the robot, and shows it again with one. */
const arenaFor = (robot: string, before: Settings): Partial<Settings> =>
  (robot === NO_ROBOT) === (before.robot === NO_ROBOT) ? {} : { showArena: robot !== NO_ROBOT };

/** The choice for a further device; `null` for the first, whose hardware is in the settings. */
function wishOf(device: FurtherDevice | null): HardwareWish | null {
  if (device === null) return null;
  const { device: id, firmware, robot, robotOptions } = device;
  return { device: id, firmware, robot, robotOptions };
}

/**
 * Returns a function that changes settings. Another device ends the run, so a notice says so; while course and devices
 * must stay as they are, it is refused.
 */
function changing(app: Parts) {
  const { settings, run, notices, work } = app;
  return (wish: Partial<Settings>, own = wish): void => {
    const shown = furtherDevice(work.work.value.project, work.place.value);
    const before = { ...settings.current.value, ...wishOf(shown) };
    const isOther = (parts: typeof deviceSettings): boolean =>
      JSON.stringify(parts({ ...before, ...wish })) !== JSON.stringify(parts(before));
    if (isOther(deviceSettings) && work.staysAsItIs()) return;
    if (run.isActive.value && isOther(deviceSettings)) {
      const isDevice = isOther(({ device, firmware, robot }) => [device, firmware, robot]);
      notices.show({ kind: 'info', key: isDevice ? 'notice.deviceChanged' : 'notice.robotChanged' });
    }
    if (shown === null) settings.change(wish, own);
    else changeFurther(app, wish);
  };
}

/** Changes settings for a further device: the hardware is its own, the rest holds for all. */
function changeFurther(
  { settings, work }: Parts,
  { device, firmware, robot, robotOptions, ...rest }: Partial<Settings>,
): void {
  work.changeDevice(work.place.value, {
    ...(device !== undefined && { device }),
    ...(firmware !== undefined && { firmware }),
    ...(robot !== undefined && { robot }),
    ...(robotOptions !== undefined && { robotOptions }),
  });
  if (Object.keys(rest).length > 0) settings.change(rest);
}
