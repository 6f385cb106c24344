import type { Clock } from '#core/clock';
import type { Stop } from '#core/stop';

/** Values that cross the boundary: whole numbers must fit 32 bits, other numbers are doubles, strings are short. */
export type Value = number | string | boolean | null;

/** The VM's services for a syscall. */
export interface Machine {
  /** The run's clock, already advanced to the present when a syscall starts. */
  readonly clock: Clock;
  /** When the board was last switched on or reset: its own clock (`running_time()`) counts from here. */
  readonly startUs: number;
  /** A view of the VM's memory: valid until the syscall returns. */
  memory(address: number, length: number): Uint8Array;
  /** Costs simulated time: moves the clock at once (alarms ring meanwhile). */
  spend(us: number): void;
  /**
   * Queues the Python callback with this number: the VM calls the library's dispatcher with it at its next jump.
   *
   * @returns false if the queue is full
   */
  schedule(callback: number): boolean;
  /** Registers a release (of an alarm, a listener) for the end of this MicroPython: a reset, a soft reboot. */
  onEnd(stop: Stop): void;
}

/**
 * Returned by a syscall that blocks. The VM lets time pass until `untilUs`, until `ready()` (called after every alarm)
 * is true, or until a callback or an interrupt is queued, unless it is deaf or solid. Then Python gets `result()`.
 */
export interface Wait {
  readonly untilUs: number;
  /** True for uninterruptible actions of the device (a transfer): callbacks and Ctrl-C wait for their end. */
  readonly solid?: boolean;
  /** True where the device never looks at its queue: callbacks wait for the end, a Ctrl-C ends it. */
  readonly deaf?: boolean;
  ready?(): boolean;
  result(): Value;
}

/** A function that Python can call. It never throws: it returns a negative errno or a documented value. */
export type Syscall = (...args: readonly (Value | undefined)[]) => Value | Wait;

/** All functions of the module `_hal`, by name. */
export type SyscallTable = Readonly<Record<string, Syscall>>;
