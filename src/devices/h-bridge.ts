/**
 * One of the two motors of an H-bridge driver such as the DRV8833: two inputs, each a level or a PWM signal.
 *
 *      forward  backward   motor
 *         1        0       forward
 *         0        1       backward
 *         0        0       rolls out
 *         1        1       brakes
 *
 * Source: Texas Instruments DRV8833 data sheet, "Bridge Control" and "PWM Control of Motor Speed". Simplified: a motor
 * that is left alone brakes, too, as everywhere in the world's motor law (world/drive-law.ts), so that the share of time
 * in which it is driven decides alone.
 */
import type { Wire } from '#board/wires/wire';
import type { Stop } from '#core/stop';

/** The inputs of one motor. */
export interface HBridgeInputs {
  readonly forward: Wire;
  readonly backward: Wire;
}

/**
 * Listens to a motor's inputs.
 *
 * @param drive called now and whenever they change: duty −1 (full backward) … 1 (full forward)
 */
export function attachHBridge({ forward, backward }: HBridgeInputs, drive: (duty: number) => void): Stop {
  const tell = (): void => drive(forward.fraction - backward.fraction);
  const stops = [forward, backward].flatMap((wire) => [wire.onLevel(tell), wire.onPwm(tell)]);
  tell();
  return () => stops.forEach((stop) => stop());
}
