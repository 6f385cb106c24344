import { computed, shallowRef } from 'vue';

import { nothingMeasured, type Measured, type MyRobot } from '#my-robot/my-robot';
import { greySensors, stepsOf, type Step } from '#my-robot/programs';
import { robotTypes } from '#robots/index';
import type { RobotType } from '#robots/robot';
import { idealTraits } from '#robots/traits';
import { useHardware } from '../../session/work/hardware/use-hardware';
import type { Workplace } from '../../session/work/model/parts';
import { useFit, type Fitter } from './use-fit';

/** Measuring the pupil's own robot: every number is kept at once, and the robot is fitted to them anew. */
export function useMyRobot(app: Workplace, fitter: Fitter) {
  const { settings } = app;
  const hardware = useHardware(app);
  const kept = computed(() => settings.current.value.myRobot);
  const chosen = shallowRef(kept.value?.robot ?? hardware.value?.robot?.id ?? robotTypes[0]?.id ?? '');
  const type = computed<RobotType | null>(() => robotTypes.find(({ id }) => id === chosen.value) ?? null);
  /**
   * Numbers belong to one type: another type begins anew, and those of the first are shown again after going back to it
   * unsaved.
   */
  const mine = computed<MyRobot>(() => {
    const blank = { name: '', robot: chosen.value, used: false, measured: nothingMeasured, traits: idealTraits };
    return kept.value?.robot === chosen.value ? kept.value : blank;
  });
  const measured = computed(() => mine.value.measured);
  const isMeasured = computed(() => isAnything(measured.value));
  function keep(change: Partial<MyRobot>): void {
    settings.change({ myRobot: { ...mine.value, ...change } });
  }

  const { state, again } = useFit({
    robot: chosen,
    measured,
    isMeasured,
    fitter,
    found: (fit) => keep({ traits: fit.traits }),
  });

  return {
    type,
    mine,
    measured,
    isMeasured,
    state,
    steps: computed<readonly Step[]>(() => (type.value === null ? [] : stepsOf(type.value))),
    greySensors: computed<readonly string[]>(() => (type.value === null ? [] : greySensors(type.value))),
    choose: (robot: string): void => void (chosen.value = robot),
    rename: (name: string): void => keep({ name }),
    measure: (change: Partial<Measured>): void => keep({ measured: { ...measured.value, ...change } }),
    /** Sets whether runs use the measured robot. */
    use: (used: boolean): void => keep({ used }),
    forget: (): void => settings.change({ myRobot: null }),
    again,
  };
}

const isAnything = ({ drives, turnDeg, echoesMm, line }: Measured): boolean =>
  [...Object.values(drives), turnDeg, ...echoesMm].some((value) => value !== null) || Object.keys(line).length > 0;

/** Whether a step has all its numbers, some, or none. */
export function stepState(step: Step, measured: Measured, sensors: readonly string[]): 'done' | 'begun' | 'open' {
  const values: Readonly<Record<Step, readonly unknown[]>> = {
    straight: Object.values(measured.drives),
    turn: [measured.turnDeg],
    distance: measured.echoesMm,
    line: sensors.map((sensor) => measured.line[sensor] ?? null),
  };
  const there = values[step].filter((value) => value !== null).length;
  if (there === values[step].length) return 'done';
  return there > 0 ? 'begun' : 'open';
}
