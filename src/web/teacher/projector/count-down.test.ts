import { describe, expect, it } from 'vitest';

import { CountDown, digitsOf, type KeptTimer } from './count-down';

/** A clock that goes when it is told to. */
function clockAt(startMs = 5_000_000) {
  let nowMs = startMs;
  let waiting: { readonly atMs: number; readonly act: () => void }[] = [];
  return {
    now: () => nowMs,
    after(ms: number, act: () => void) {
      const one = { atMs: nowMs + ms, act };
      waiting.push(one);
      return () => void (waiting = waiting.filter((other) => other !== one));
    },
    /** Lets so many seconds pass, with all that happens in them. */
    pass(seconds: number) {
      const untilMs = nowMs + seconds * 1000;
      for (;;) {
        const next = waiting.filter(({ atMs }) => atMs <= untilMs).sort((a, b) => a.atMs - b.atMs)[0];
        if (next === undefined) break;
        waiting = waiting.filter((one) => one !== next);
        nowMs = next.atMs;
        next.act();
      }
      nowMs = untilMs;
    },
    /** The laptop is shut for so many seconds: nothing happens, but time passes. */
    sleep(seconds: number) {
      nowMs += seconds * 1000;
    },
    waiting: () => waiting.length,
  };
}

function timer(kept: KeptTimer | null = null) {
  const clock = clockAt();
  const seen: KeptTimer[] = [];
  let ends = 0;
  const down = new CountDown(clock, kept, (one) => void seen.push(one), () => void (ends += 1)); // prettier-ignore
  return { clock, down, seen, ends: () => ends, shows: () => digitsOf(down.seconds.value) };
}

describe('the timer of the projector view', () => {
  it('has 10 minutes at first, and stands', () => {
    const { down, shows, clock } = timer();
    expect([shows(), down.phase.value]).toEqual(['10:00', 'ready']);
    clock.pass(5);
    expect(shows()).toBe('10:00');
  });

  it('counts down by the clock on the wall, to 0:00, and says so once', () => {
    const { down, shows, clock, ends } = timer();
    down.set(5);
    down.start();
    clock.pass(1);
    expect([shows(), down.phase.value]).toEqual(['4:59', 'running']);
    clock.pass(298);
    expect([shows(), ends()]).toEqual(['0:01', 0]);
    clock.pass(1);
    expect([shows(), down.phase.value, ends()]).toEqual(['0:00', 'over', 1]);
    clock.pass(60);
    expect([shows(), ends(), clock.waiting()]).toEqual(['0:00', 1, 0]);
  });

  it('stands when it is paused, in the midst of a second, too, and goes on from there', () => {
    const { down, shows, clock } = timer();
    down.set(5);
    down.start();
    clock.pass(2.4);
    down.pause();
    clock.pass(600);
    expect([shows(), down.phase.value]).toEqual(['4:58', 'paused']);
    down.start();
    clock.pass(0.6);
    expect(shows()).toBe('4:57');
  });

  it('goes back to what was set', () => {
    const { down, shows, clock } = timer();
    down.set(20);
    down.start();
    clock.pass(90);
    down.reset();
    expect([shows(), down.phase.value, clock.waiting()]).toEqual(['20:00', 'ready', 0]);
  });

  it('gets a minute more while it runs; reset forgets it', () => {
    const { down, shows, clock } = timer();
    down.set(5);
    down.start();
    clock.pass(30);
    down.add(1);
    expect([shows(), down.phase.value]).toEqual(['5:30', 'running']);
    clock.pass(1);
    expect(shows()).toBe('5:29');
    down.reset();
    expect(shows()).toBe('5:00');
  });

  it('runs on with another minute after its end, and ends a second time', () => {
    const { down, shows, clock, ends } = timer();
    down.set(1);
    down.start();
    clock.pass(70);
    down.add(1);
    expect([shows(), down.phase.value]).toEqual(['1:00', 'running']);
    clock.pass(60);
    expect([down.phase.value, ends()]).toEqual(['over', 2]);
  });

  it('is set minute by minute, from 1 to 99', () => {
    const { down, shows } = timer();
    down.set(2);
    down.add(-1);
    down.add(-1);
    expect([shows(), down.phase.value]).toEqual(['1:00', 'ready']);
    down.set(99);
    down.add(1);
    expect(shows()).toBe('99:00');
    down.start();
    down.add(1);
    expect(shows()).toBe('99:00');
  });

  it('counts the time in which the laptop slept', () => {
    const { down, shows, clock, ends } = timer();
    down.set(5);
    down.start();
    clock.pass(10);
    clock.sleep(200);
    clock.pass(1);
    expect(shows()).toBe('1:29');
    clock.sleep(1000);
    clock.pass(1);
    expect([shows(), ends()]).toEqual(['0:00', 1]);
  });

  it('is the same after a reload: it has gone on meanwhile', () => {
    const before = timer();
    before.down.set(20);
    before.down.start();
    before.clock.pass(60);
    before.down.pause();
    before.down.start();
    const after = timer(before.seen.at(-1));
    after.clock.pass(120);
    expect([after.shows(), after.down.phase.value]).toEqual(['18:00', 'running']);
    after.down.reset();
    expect(after.shows()).toBe('20:00');
  });

  it('is over if it ended while nobody looked, and makes no more of it', () => {
    const { clock, shows, down, ends } = timer({ setMs: 60_000, leftMs: 60_000, endsMs: 1 });
    expect([shows(), down.phase.value]).toEqual(['0:00', 'over']);
    clock.pass(5);
    expect(ends()).toBe(0);
  });
});
