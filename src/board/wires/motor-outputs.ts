import type { Wire } from './wire';

/** The wires of one motor connector. */
export interface MotorWires {
  readonly name: string;
  /** IN1 of the driver: the direction while the mode wire is high. */
  readonly direction: Wire;
  /** IN2 of the driver: the speed while the mode wire is high. */
  readonly speed: Wire;
}

/** The output of a motor connector to its motor. */
export interface MotorOutput {
  readonly name: string;
  /** Mean share of the supply, −1 … 1, positive forwards. */
  readonly duty: number;
}

/**
 * The motor driver of the Calliope mini 3, two bridges with a common mode wire.
 *
 * Mode high (phase/enable): direction 0 forwards, 1 backwards, the speed wire's duty is the motor's. Mode low (IN/IN):
 * forwards while only IN1 is high, backwards while only IN2 is, braked or free otherwise. Undriven inputs are low.
 * Source: Texas Instruments DRV8835 datasheet, tables of the IN/IN and the phase/enable mode.
 */
export class MotorOutputs {
  constructor(
    private readonly mode: Wire,
    private readonly motors: readonly MotorWires[],
  ) {}

  /** The present output to the motors. */
  get outputs(): readonly MotorOutput[] {
    const isPhaseEnable = this.mode.level === 1;
    return this.motors.map(({ name, direction, speed }) => {
      if (!isPhaseEnable) return { name, duty: direction.fraction - speed.fraction };
      return { name, duty: direction.level === 1 ? -speed.fraction : speed.fraction };
    });
  }
}
