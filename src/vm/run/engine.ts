import type { Clock } from '#core/clock';
import type { Stop } from '#core/stop';
import { HAL_REFERENCE, type Firmware, type Flow, type Given } from './firmware';
import type { Machine, Syscall, SyscallTable, Value, Wait } from './syscall';
import type { Memory } from './values';

/**
 * Library bytecodes that one API call may use free of charge; beyond that they cost time like the pupil's own code. The
 * firmware restarts the count with each bytecode of the program (../firmware/transform.mjs).
 */
const FREE_LIBRARY_BYTECODES = 20_000;
/** The longest stretch without a tick, in µs: keeps the counter well within 32 bits. */
const LONGEST_STRETCH_US = 1_000_000;
/** Size of the stack of a suspended program: the deepest recursion that the VM allows needs less (engine tests). */
const UNWIND_BYTES = 1024 * 1024;

/** Upper limit for a program's buffer: the device's heap. */
const MOST_BYTES = 64 * 1024;

const WANTS_TO_RUN = 1;
const EXCEPTION_WAITS = 2;
const UNWINDING = 1;

/** Lets a program stop before its time is over. Neither watch nor stop changes its time, memory or output. */
export interface Hold {
  /** Asked before bytecodes of the program whether to stop there; `null`: no watch, at no cost. */
  watch: Watch | null;
  /** True once the watch has stopped the program; the next `run` goes on from there. */
  isHeld: boolean;
}

/** Looks at a program, bytecode by bytecode. */
export interface Watch {
  /**
   * The program is about to go on: marks the bytecodes before which `look` shall be called (marks.ts).
   *
   * @param isNew it was another watch, or none, that looked at the program last: a bytecode before which the program
   *   stands is passed
   */
  begin(isNew: boolean): void;
  /** The program goes on with what it was in the midst of: no bytecode is to be passed. */
  passed(): void;
  /**
   * Whether the program shall stop before the bytecode that is next.
   *
   * @param catchUp brings the clock to this bytecode; until it is called, it may be behind
   */
  look(catchUp: () => void): boolean;
}

/** The facts that the loaded library reports. */
export interface Agreed {
  /** Address of its function that callbacks go through; 0: there is none yet. */
  readonly dispatcher: number;
  /** The functions of `_hal` that Python cannot look up any more. */
  readonly hidden: ReadonlySet<string>;
}

/** An error in our code or the C code: the VM is in a state that it cannot leave, and its run ends. */
export class VmFault extends Error {}

/**
 * Runs the firmware in pieces under the run's clock. It turns the firmware's counters into simulated time, answers
 * syscalls, lets time pass while Python waits, and suspends the program when its time is used up.
 */
export class Engine implements Machine {
  private readonly table: readonly Syscall[];
  private readonly references: ReadonlyMap<string, number>;
  private readonly unwindBuffer: number;
  /** The last value that `gas` was set to: the difference to the present value is the time used since, in µs. */
  private stretchUs = 0;
  private limitUs = 0;
  private suspended = false;
  private running = false;
  private waiting: Wait | null = null;
  /** Time that printing took and that has not passed yet. */
  private owedUs = 0;
  /** A syscall waits until that time has passed. */
  private isDue = false;
  private pausing = false;
  agreed: Agreed = { dispatcher: 0, hidden: new Set() };
  private ending = false;
  /** The watch that was there when the program went on last. */
  private watch: Watch | null = null;
  private stops: Stop[] = [];

  private readonly firmware: Firmware;
  private readonly ram: Memory;
  private readonly flow: Flow;
  private readonly hold: Hold;

  constructor(
    running: { readonly firmware: Firmware; readonly memory: Memory; readonly flow: Flow; readonly hold: Hold },
    readonly clock: Clock,
    readonly startUs: number,
    syscalls: (engine: Engine) => SyscallTable,
  ) {
    this.firmware = running.firmware;
    this.ram = running.memory;
    this.flow = running.flow;
    this.hold = running.hold;
    const named = Object.entries(syscalls(this));
    this.table = named.map(([, call]) => call);
    this.references = new Map(named.map(([name], place) => [name, HAL_REFERENCE + 1 + place]));
    this.unwindBuffer = this.firmware.malloc(UNWIND_BYTES);
  }

  // --- what a syscall may ask of the machine -----------------------------------------------------------------------

  memory(address: number, length: number): Uint8Array {
    const start = Math.max(0, address);
    return this.ram.bytes.subarray(start, start + Math.min(Math.max(0, length), MOST_BYTES));
  }

  spend(us: number): void {
    if (us > 0) this.clock.advanceTo(this.clock.nowUs + Math.ceil(us));
  }

  schedule(callback: number): boolean {
    const { dispatcher } = this.agreed;
    return dispatcher !== 0 && this.firmware.mp_sched_schedule(dispatcher, (callback << 1) | 1) !== 0;
  }

  /** The library's function (its address) that callbacks go through. */
  setDispatcher(address: number): void {
    this.agreed = { ...this.agreed, dispatcher: address };
  }

  onEnd(stop: Stop): void {
    this.stops.push(stop);
  }

  /** Raises the exception object at this address in the main program, at its next jump. */
  throwInProgram(address: number): void {
    this.firmware.set_pending(address);
  }

  /** Forgets an exception that waits to be raised in the program. */
  forgetInterrupt(): void {
    if (this.firmware.queued() & EXCEPTION_WAITS) this.firmware.set_pending(0);
  }

  /** Sets whether code that is compiled from now on prints the values of its expressions. */
  echo(on: boolean): void {
    this.firmware.echo.value = Number(on);
  }

  /** Makes `run` return at the next wait of a syscall, as if its time were over. */
  pause(): void {
    this.pausing = true;
  }

  /** Ends the program here: nothing of it runs again. */
  end(): void {
    this.ending = true;
  }

  /** Hides the functions of these names in `_hal` from now on. Python keeps those that it has already taken. */
  hide(names: readonly string[]): void {
    this.agreed = { ...this.agreed, hidden: new Set(names) };
  }

  /** Releases everything that was registered with `onEnd`. */
  dispose(): void {
    for (const stop of this.stops) stop();
    this.stops = [];
  }

  // --- running -----------------------------------------------------------------------------------------------------

  /**
   * Runs `enter` (a call into the firmware) until it returns or the clock has reached the limit. If called again while
   * suspended, it continues.
   *
   * @returns true once the call has returned or the program was ended, false while it is suspended
   */
  run(enter: () => void, limitUs: number): boolean {
    this.limitUs = limitUs;
    this.hold.isHeld = false;
    this.beginWatch();
    if (this.suspended) this.rewind();
    else this.refill();
    this.suspended = false;
    this.running = true;
    try {
      enter();
    } finally {
      this.running = false;
    }
    if (this.firmware.asyncify_get_state() !== UNWINDING) return true;
    this.firmware.asyncify_stop_unwind();
    this.suspended = true;
    return this.ending;
  }

  /** True within `run`. */
  get isRunning(): boolean {
    return this.running;
  }

  /** Raises KeyboardInterrupt at the program's next jump. */
  interrupt(): void {
    this.firmware.mp_sched_keyboard_interrupt();
  }

  /** A counter has run out. */
  tick(): void {
    if (!this.stopRewinding()) {
      if (this.firmware.library_gas.value <= 0) {
        this.firmware.library_gas.value = FREE_LIBRARY_BYTECODES;
        this.spend(FREE_LIBRARY_BYTECODES);
      }
      this.catchUp();
    } else if (this.owedUs === 0) return this.refill();
    if (!this.payOwed() || this.clock.nowUs >= this.limitUs || this.ending) this.suspend();
    else this.refill();
  }

  /** A marked bytecode is next: the watch may stop the program there. */
  look(): void {
    if (this.stopRewinding()) return this.goOnFromHere(); // it was stopped here
    this.hold.isHeld = this.watch?.look(this.catchUpNow) ?? false;
    if (!this.hold.isHeld) return;
    this.catchUp();
    this.suspend();
  }
  private goOnFromHere(): void {
    this.watch?.passed();
    this.refill();
  }
  private readonly catchUpNow = (): void => this.catchUp();

  /**
   * The program prints: this takes as long as the serial line needs. The time passes before the program's next bytecode
   * or syscall, where the program can be suspended.
   */
  print(us: number): void {
    this.catchUp();
    this.owedUs += Math.ceil(us);
    this.refill();
  }

  /** The reference of a function of `_hal`, or −1. */
  lookup(name: string): number {
    return this.agreed.hidden.has(name) ? -1 : (this.references.get(name) ?? -1);
  }

  /** Python calls a function of `_hal`. A program that was suspended in such a call also resumes here. */
  call(
    reference: number,
    resultAddress: number,
    a?: Given,
    b?: Given,
    c?: Given,
    d?: Given,
    e?: Given,
    f?: Given,
    g?: Given,
    h?: Given,
  ): void {
    if (!this.stopRewinding()) this.catchUp();
    else if (!this.isDue) {
      this.watch?.passed();
      if (this.waiting) this.goOnWaiting(this.waiting, resultAddress);
      return;
    }
    this.isDue = !this.payOwed();
    if (this.isDue) return this.suspend();
    const answer = this.table[reference - HAL_REFERENCE - 1]?.(a, b, c, d, e, f, g, h) ?? null;
    if (this.ending) this.suspend();
    else if (typeof answer === 'object' && answer) this.goOnWaiting(answer, resultAddress);
    else this.answer(answer, resultAddress);
  }

  // --- inside ------------------------------------------------------------------------------------------------------

  private beginWatch(): void {
    const { watch } = this.hold;
    watch?.begin(watch !== this.watch);
    if (watch === null) this.firmware.marks.value = 0;
    this.watch = watch;
  }

  /** Resumes the suspended call: the firmware builds its stack up again, and ends at `tick` or `call`. */
  private rewind(): void {
    this.firmware.asyncify_start_rewind(this.unwindBuffer);
    this.flow.isRewinding = true;
  }

  private stopRewinding(): boolean {
    if (!this.flow.isRewinding) return false;
    this.firmware.asyncify_stop_rewind();
    this.flow.isRewinding = false;
    return true;
  }

  /** Lets time pass until Python's wait is over, or until this stretch of time is used up. */
  private goOnWaiting(wait: Wait, resultAddress: number): void {
    this.waiting = wait;
    if (this.pausing) {
      this.pausing = false;
      return this.suspend();
    }
    while (!this.isOver(wait)) {
      const next = Math.min(wait.untilUs, this.clock.nextAlarmUs);
      // Without a limit and without an alarm there is no time to move to.
      if (next === Infinity && this.limitUs === Infinity) return this.suspend();
      if (next > this.limitUs) {
        this.clock.advanceTo(Math.max(this.limitUs, this.clock.nowUs));
        return this.suspend();
      }
      this.clock.advanceTo(Math.max(next, this.clock.nowUs));
    }
    this.waiting = null;
    this.answer(wait.result(), resultAddress);
  }

  /**
   * True once a wait is over. Inside a callback the scheduler is locked: no callback can run, and an interrupt waits
   * for its end.
   */
  private isOver(wait: Wait): boolean {
    const isCut = wait.solid !== true && (this.firmware.queued() & (wait.deaf ? EXCEPTION_WAITS : WANTS_TO_RUN)) !== 0;
    return this.clock.nowUs >= wait.untilUs || wait.ready?.() === true || isCut || this.ending;
  }

  /** Lets the time of printing pass. @returns false if the available time is used up before */
  private payOwed(): boolean {
    if (this.owedUs === 0) return true;
    const now = this.clock.nowUs;
    const us = Math.min(this.owedUs, Math.max(this.limitUs - now, 0));
    this.owedUs -= us;
    this.clock.advanceTo(now + us);
    return this.owedUs === 0;
  }

  private answer(value: Value, resultAddress: number): void {
    this.ram.write(value, resultAddress);
    this.refill();
  }

  /** Advances the clock by the time that the program has used since the last call. */
  private catchUp(): void {
    const left = this.firmware.gas.value;
    const usedUs = this.stretchUs - left;
    this.stretchUs = left;
    if (usedUs > 0) this.clock.advanceTo(this.clock.nowUs + usedUs);
  }

  /** Sets the counters so that the next tick comes exactly at the next alarm, or at the end of the available time. */
  private refill(): void {
    const now = this.clock.nowUs;
    const untilUs = this.owedUs > 0 ? now : Math.min(this.clock.nextAlarmUs, this.limitUs, now + LONGEST_STRETCH_US);
    this.stretchUs = Math.max(1, untilUs - now);
    this.firmware.gas.value = this.stretchUs;
  }

  private suspend(): void {
    // The buffer begins with two words: where its filled part ends, and where the buffer ends.
    this.ram.setWord(this.unwindBuffer, this.unwindBuffer + 8);
    this.ram.setWord(this.unwindBuffer + 4, this.unwindBuffer + UNWIND_BYTES);
    this.firmware.asyncify_start_unwind(this.unwindBuffer);
  }
}
