/**
 * HC-SR04 ultrasonic ranger: one trigger wire in, one echo wire out. Echo idles low.
 *
 *      trigger ──┐        ┌─ a falling edge after any high time starts a measurement
 *                └────────
 *      echo    ______┌────────────┐____   high for the way there and back
 *                    ↑            ↑
 *              START_US later     distance × US_PER_MM later still
 *
 * Where trigger and echo are the same wire (a socket with three contacts), the sensor drives it only while the echo
 * lasts, and its own edges start nothing. Two drivers that do so on real robots: 4tronix BitBot bitbot.ts (sonar),
 * Tiger-Jython/Robotics-Libraries mbbitbot.py.
 *
 * Source: ElecFreaks "HC-SR04 User Guide", timing diagram. The guide asks for a trigger of 10 µs; school libraries
 * send two `write_digital` calls back to back (Tiger-Jython Robotics-Libraries mbrobot.py) and work on real robots,
 * so any high time counts.
 */
import type { Wire } from '#board/wires/wire';
import type { Clock } from '#core/clock';
import type { Stop } from '#core/stop';

/**
 * There and back: 58.2 µs per cm, the constant of the older school drivers (Tiger-Jython/Aplu-Libraries mbrobot.py). It is
 * a speed of sound of 343.6 m/s, dry air of 20.5 °C. Other drivers divide by 58 (HC-SR04 User Guide) to 59.3 (DFRobot).
 */
export const US_PER_MM = 5.82;

/**
 * From the trigger's falling edge to the echo's rising edge. Chosen: the burst of eight periods at 40 kHz takes 200 µs
 * (user guide), the rest is the board's own processing. Long enough for a slow driver to be listening in time.
 */
export const START_US = 450;

/** Nearest measurable distance, 2 cm: HC-SR04 User Guide. A nearer target reads as 2 cm (chosen). */
export const NEAREST_MM = 20;

/** Farthest measurable distance, 450 cm: range check of jdonwells/micropython-MaqueenPlusV2 for the sensor sold with the robot. */
export const FARTHEST_MM = 4500;

/** Length of the echo of boards that raise it without a target: the threshold in jdonwells/micropython-MaqueenPlusV2. */
export const NO_TARGET_US = 38_000;

/** Choices for the sensor's behaviour. */
export interface HcSr04Options {
  /**
   * The answer when nothing is in range. `none`: echo stays low, as DFRobot describes for the sensor it ships
   * (comment in pxt-DFRobot_MaqueenPlus_v20). `long-pulse`: echo is high for 38 ms, as the classic HC-SR04 does.
   *
   * @default 'none'
   */
  readonly withoutTarget?: 'none' | 'long-pulse';
}

/**
 * Makes two wires, or one that serves for both, behave like an HC-SR04. A trigger while an echo is on its way is ignored.
 *
 * @param distanceMm called once per measurement, at the trigger: distance of the obstacle, in mm; `Infinity`: none
 * @returns lets go of the wires and forgets a running measurement
 */
export function attachHcSr04(
  clock: Clock,
  wires: { readonly trigger: Wire; readonly echo: Wire },
  distanceMm: () => number,
  options: HcSr04Options = {},
): Stop {
  const echo = wires.echo.connect('HC-SR04 echo');
  const rest = (): void => {
    if (wires.echo === wires.trigger) echo.release();
    else echo.drive(0);
  };
  rest();
  let busy = false;
  let cancel: Stop = () => undefined;

  const measure = (): void => {
    const lengthUs = echoUs(distanceMm(), options.withoutTarget ?? 'none');
    if (lengthUs === null) return;
    busy = true;
    const riseUs = clock.nowUs + START_US;
    cancel = clock.at(riseUs, () => {
      echo.drive(1);
      cancel = clock.at(riseUs + lengthUs, () => {
        rest();
        busy = false;
      });
    });
  };

  const stopListening = wires.trigger.onLevel((level) => {
    if (level === 0 && !busy) measure();
  });
  return () => {
    cancel();
    stopListening();
    echo.detach();
  };
}

/** Length of the echo in whole µs, or `null` if there is no echo. */
function echoUs(distanceMm: number, withoutTarget: 'none' | 'long-pulse'): number | null {
  if (distanceMm <= FARTHEST_MM) return Math.round(Math.max(distanceMm, NEAREST_MM) * US_PER_MM);
  return withoutTarget === 'none' ? null : NO_TARGET_US;
}
