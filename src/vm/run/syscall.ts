import type { Clock } from '#core/clock';
import type { Stop } from '#core/stop';

/** What crosses the boundary: whole numbers must fit 32 bits, other numbers are doubles, strings are short. */
export type Value = number | string | boolean | null;

/** What a syscall may ask of the VM. */
export interface Machine {
  /** The run's clock, already brought up to now when a syscall starts. */
  readonly clock: Clock;
  /** When the board was switched on or reset last: its own clock (`running_time()`) counts from here. */
  readonly startUs: number;
  /** A view of the VM's memory: valid until the syscall returns. */
  memory(address: number, length: number): Uint8Array;
  /** Costs simulated time: moves the clock at once (alarms ring meanwhile). */
  spend(us: number): void;
  /**
   * Queues the Python callback with this number: the VM calls the library's dispatcher with it at its next jump.
   *
   * @returns false when the queue is full
   */
  schedule(callback: number): boolean;
  /** Lets go of something (an alarm, a listener) when this MicroPython ends: by a reset, a soft reboot. */
  onEnd(stop: Stop): void;
}

/**
 * Returned by a syscall that blocks: the VM lets time pass until `untilUs`, or until `ready()` (asked after every
 * alarm) is true, or less when a callback or an interrupt is queued; then Python gets `result()`.
 */
export interface Wait {
  readonly untilUs: number;
  /** True for what the device does without a look at anything else (a transfer): callbacks and Ctrl-C wait for its end. */
  readonly solid?: boolean;
  ready?(): boolean;
  result(): Value;
}

/** A function that Python can call. It never throws: it gives a negative errno or a documented value. */
export type Syscall = (...args: readonly Value[]) => Value | Wait;

/** All functions of the module `_hal`, by name. */
export type SyscallTable = Readonly<Record<string, Syscall>>;
