import { describe, expect, it } from 'vitest';

import { Clock } from './clock';

/** A clock with a list of what rang, each with the time that it was then. */
function setUp() {
  const clock = new Clock();
  const rang: string[] = [];
  const note = (name: string) => () => void rang.push(`${name} ${clock.nowUs}`);
  return { clock, rang, note };
}

describe('the clock of a run', () => {
  it('begins at 0 µs with no alarm', () => {
    const { clock } = setUp();
    expect(clock.nowUs).toBe(0);
    expect(clock.nextAlarmUs).toBe(Infinity);
  });

  it('stands still until it is moved, and is then exactly where it was moved to', () => {
    const { clock } = setUp();
    clock.advanceTo(1_234_567);
    expect(clock.nowUs).toBe(1_234_567);
    clock.advanceTo(1_234_567);
    expect(clock.nowUs).toBe(1_234_567);
  });

  it('does not go back, and says from where to where', () => {
    const { clock } = setUp();
    clock.advanceTo(500);
    expect(() => clock.advanceTo(499)).toThrow(new RangeError('The clock cannot go back from 500 to 499 µs.'));
    expect(clock.nowUs).toBe(500);
  });

  it('goes on counting single microseconds after an hour', () => {
    const { clock, rang, note } = setUp();
    clock.advanceTo(3_600_000_000);
    clock.at(3_600_000_001, note('late'));
    clock.advanceTo(3_600_000_002);
    expect(rang).toEqual(['late 3600000001']);
    expect(clock.nowUs).toBe(3_600_000_002);
  });
});

describe('alarms', () => {
  it('ring in the order of their time, whatever the order in which they were set', () => {
    const { clock, rang, note } = setUp();
    for (const timeUs of [50, 10, 40, 20, 30]) clock.at(timeUs, note('alarm'));
    clock.advanceTo(100);
    expect(rang).toEqual(['alarm 10', 'alarm 20', 'alarm 30', 'alarm 40', 'alarm 50']);
  });

  it('ring in the order in which they were set if they are for the same microsecond', () => {
    const { clock, rang, note } = setUp();
    for (const name of ['first', 'second', 'third', 'fourth', 'fifth']) clock.at(7, note(name));
    clock.advanceTo(7);
    expect(rang).toEqual(['first 7', 'second 7', 'third 7', 'fourth 7', 'fifth 7']);
  });

  it('keep both orders among a thousand that are set all mixed', () => {
    const { clock } = setUp();
    const rang: (readonly [timeUs: number, order: number])[] = [];
    let mixed = 1;
    for (let order = 0; order < 1000; order++) {
      mixed = (mixed * 48_271) % 2_147_483_647; // Park and Miller's generator: the same numbers in every run
      const timeUs = mixed % 50;
      clock.at(timeUs, () => void rang.push([timeUs, order]));
    }
    const sorted = (): typeof rang => rang.slice().sort(([a, i], [b, j]) => a - b || i - j);
    clock.advanceTo(49);
    expect(rang).toHaveLength(1000);
    expect(rang).toEqual(sorted());
  });

  it('ring at their own time, not at the time that the clock is moved to', () => {
    const { clock, rang, note } = setUp();
    clock.at(30, note('alarm'));
    clock.advanceTo(1000);
    expect(rang).toEqual(['alarm 30']);
    expect(clock.nowUs).toBe(1000);
  });

  it('ring if they are for the very microsecond that the clock is moved to, and wait if for the next one', () => {
    const { clock, rang, note } = setUp();
    clock.at(100, note('on time'));
    clock.at(101, note('later'));
    clock.advanceTo(100);
    expect(rang).toEqual(['on time 100']);
    expect(clock.nextAlarmUs).toBe(101);
    clock.advanceTo(101);
    expect(rang).toEqual(['on time 100', 'later 101']);
  });

  it('ring once', () => {
    const { clock, rang, note } = setUp();
    clock.at(5, note('alarm'));
    clock.advanceTo(10);
    clock.advanceTo(20);
    expect(rang).toEqual(['alarm 5']);
    expect(clock.nextAlarmUs).toBe(Infinity);
  });

  it('ring at the next whole microsecond if they are for a fraction of one', () => {
    const { clock, rang, note } = setUp();
    clock.at(10.2, note('alarm'));
    expect(clock.nextAlarmUs).toBe(11);
    clock.advanceTo(20);
    expect(rang).toEqual(['alarm 11']);
  });

  it('set for the past ring when the clock is next moved, at the time it is then', () => {
    const { clock, rang, note } = setUp();
    clock.advanceTo(100);
    clock.at(40, note('missed'));
    expect(rang).toEqual([]);
    expect(clock.nextAlarmUs).toBe(100);
    clock.advanceTo(150);
    expect(rang).toEqual(['missed 100']);
  });

  it('set for the past take their turn behind those of now that were set before', () => {
    const { clock, rang, note } = setUp();
    clock.advanceTo(100);
    clock.at(100, note('now'));
    clock.at(-5, note('missed'));
    clock.advanceTo(100);
    expect(rang).toEqual(['now 100', 'missed 100']);
  });

  it('set by an alarm ring on the same move, if they are due by then', () => {
    const { clock, rang, note } = setUp();
    clock.at(10, () => {
      clock.at(25, note('child'));
      clock.at(31, note('late child'));
    });
    clock.at(20, note('alarm'));
    clock.advanceTo(30);
    expect(rang).toEqual(['alarm 20', 'child 25']);
    expect(clock.nextAlarmUs).toBe(31);
  });

  it('set by an alarm for its own microsecond ring in it, behind all that were set before', () => {
    const { clock, rang, note } = setUp();
    clock.at(10, () => void clock.at(clock.nowUs, note('child')));
    clock.at(10, note('brother'));
    clock.advanceTo(10);
    expect(rang).toEqual(['brother 10', 'child 10']);
  });

  it('may move the clock themselves, and leave it where they moved it to', () => {
    const { clock, rang, note } = setUp();
    clock.at(10, () => clock.advanceTo(60));
    clock.at(40, note('on the way'));
    clock.advanceTo(50);
    expect(rang).toEqual(['on the way 40']);
    expect(clock.nowUs).toBe(60);
  });

  it('still ring on the next move after an error in one of them', () => {
    const { clock, rang, note } = setUp();
    clock.at(10, () => {
      throw new Error('broken');
    });
    clock.at(10, note('next'));
    expect(() => clock.advanceTo(20)).toThrow('broken');
    expect(clock.nowUs).toBe(10);
    clock.advanceTo(20);
    expect(rang).toEqual(['next 10']);
  });
});

describe('a cancelled alarm', () => {
  it('does not ring, and the clock no longer waits for it', () => {
    const { clock, rang, note } = setUp();
    const cancel = clock.at(10, note('cancelled'));
    clock.at(20, note('alarm'));
    cancel();
    expect(clock.nextAlarmUs).toBe(20);
    clock.advanceTo(30);
    expect(rang).toEqual(['alarm 20']);
  });

  it('may be cancelled twice, and after it has rung: nothing else is touched', () => {
    const { clock, rang, note } = setUp();
    const cancel = clock.at(10, note('first'));
    clock.at(20, note('second'));
    clock.advanceTo(15);
    cancel();
    cancel();
    clock.advanceTo(25);
    expect(rang).toEqual(['first 10', 'second 20']);
  });

  it('may be cancelled by an alarm of the same microsecond that was set before it', () => {
    const { clock, rang, note } = setUp();
    clock.at(10, () => cancel());
    const cancel = clock.at(10, note('cancelled'));
    clock.at(10, note('alarm'));
    clock.advanceTo(10);
    expect(rang).toEqual(['alarm 10']);
  });

  it('leaves the order of the others as it was, wherever it stood among them', () => {
    for (let cancelled = 0; cancelled < 12; cancelled++) {
      const { clock, rang, note } = setUp();
      const cancels = Array.from({ length: 12 }, (_, place) => clock.at((place * 5) % 12, note('alarm')));
      cancels[cancelled]!();
      clock.advanceTo(20);
      const others = Array.from({ length: 12 }, (_, timeUs) => timeUs).filter(
        (timeUs) => timeUs !== (cancelled * 5) % 12,
      );
      expect(rang).toEqual(others.map((timeUs) => `alarm ${timeUs}`));
    }
  });
});

describe('a repeated alarm', () => {
  it('rings first one period from now, then each period, and never drifts', () => {
    const { clock, rang, note } = setUp();
    clock.advanceTo(3);
    clock.every(4000, note('step'));
    clock.advanceTo(12_002);
    expect(rang).toEqual(['step 4003', 'step 8003']);
    clock.advanceTo(12_003);
    expect(rang.at(-1)).toBe('step 12003');
  });

  it('rings as often on one long move as on many short ones', () => {
    const long = setUp();
    const short = setUp();
    for (const { clock, note } of [long, short]) {
      clock.every(7, note('seven'));
      clock.every(3, note('three'));
    }
    long.clock.advanceTo(100);
    for (let timeUs = 1; timeUs <= 100; timeUs++) short.clock.advanceTo(timeUs);
    expect(long.rang).toHaveLength(14 + 33);
    expect(short.rang).toEqual(long.rang);
  });

  it('takes its turn by when it was set again: at 12 µs the period of 4 was renewed at 8, the one of 6 at 6', () => {
    const { clock, rang, note } = setUp();
    clock.every(4, note('four'));
    clock.every(6, note('six'));
    clock.advanceTo(12);
    expect(rang).toEqual(['four 4', 'six 6', 'four 8', 'six 12', 'four 12']);
  });

  it('ends when it is stopped from outside', () => {
    const { clock, rang, note } = setUp();
    const stop = clock.every(10, note('tick'));
    clock.advanceTo(25);
    stop();
    expect(clock.nextAlarmUs).toBe(Infinity);
    clock.advanceTo(100);
    expect(rang).toEqual(['tick 10', 'tick 20']);
  });

  it('ends when it is stopped while it rings', () => {
    const { clock, rang, note } = setUp();
    const stop = clock.every(10, () => {
      note('tick')();
      if (clock.nowUs === 30) stop();
    });
    clock.advanceTo(100);
    expect(rang).toEqual(['tick 10', 'tick 20', 'tick 30']);
    expect(clock.nextAlarmUs).toBe(Infinity);
  });

  it('goes on after an error inside it: the error ends the run, not the clockwork', () => {
    const { clock, rang, note } = setUp();
    clock.every(10, () => {
      note('tick')();
      if (clock.nowUs === 20) throw new Error('broken');
    });
    expect(() => clock.advanceTo(100)).toThrow('broken');
    expect(clock.nowUs).toBe(20);
    expect(clock.nextAlarmUs).toBe(30);
    clock.advanceTo(45);
    expect(rang).toEqual(['tick 10', 'tick 20', 'tick 30', 'tick 40']);
  });

  it('ends even if it is stopped and fails at once', () => {
    const { clock } = setUp();
    const stop = clock.every(10, () => {
      stop();
      throw new Error('broken');
    });
    expect(() => clock.advanceTo(10)).toThrow('broken');
    expect(clock.nextAlarmUs).toBe(Infinity);
  });

  it.each([0, 0.5, -10, NaN])('cannot have a period of %s µs: time would stand still', (periodUs) => {
    const { clock, note } = setUp();
    expect(() => clock.every(periodUs, note('tick'))).toThrow(
      new RangeError(`A period must be at least 1 µs, not ${periodUs}.`),
    );
    expect(clock.nextAlarmUs).toBe(Infinity);
  });
});
