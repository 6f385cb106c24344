// @vitest-environment happy-dom
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';

import { Back } from './back';

/** A history as a browser keeps it: it moves later, and reports it then. */
class Entries {
  private readonly all: unknown[] = [null];
  private at = 0;
  report: () => void = () => undefined;
  get state(): unknown {
    return this.all[this.at];
  }
  get place(): number {
    return this.at;
  }
  pushState = (state: unknown): void => {
    this.at += 1;
    this.all.splice(this.at, this.all.length, state);
  };
  go = (by: number): void => {
    setTimeout(() => {
      this.at = Math.max(0, Math.min(this.all.length - 1, this.at + by));
      this.report();
    }, 5);
  };
}

let entries: Entries;
let back: Back;
beforeEach(() => {
  vi.useFakeTimers();
  entries = new Entries();
  vi.stubGlobal('history', entries);
  vi.stubGlobal('addEventListener', (_type: string, report: () => void) => (entries.report = report));
  back = new Back(() => false);
});
afterEach(() => {
  vi.runAllTimers();
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

const closed: string[] = [];
/** Opens a layer that closes when it is asked to. */
function open(name: string): () => void {
  const gone = back.add(() => {
    closed.push(name);
    gone();
  });
  return gone;
}
const settle = (): void => void vi.advanceTimersByTime(50);
function press(by: -1 | 1): readonly string[] {
  closed.length = 0;
  entries.go(by);
  settle();
  return [...closed];
}

describe('the browser’s back button', () => {
  it('closes what lies open, on top first, and then leaves the page', () => {
    open('dialog');
    settle();
    open('question');
    settle();
    expect([entries.place, press(-1), press(-1), entries.place]).toEqual([2, ['question'], ['dialog'], 0]);
  });

  it('finds nothing of what was closed otherwise', () => {
    const close = open('dialog');
    settle();
    close();
    settle();
    expect([entries.place, press(1), entries.place]).toEqual([0, [], 0]); // forward does not bring it back
  });

  it('does not notice that a menu makes way for a dialog', () => {
    const close = open('menu');
    settle();
    close();
    open('dialog');
    settle();
    expect([entries.place, press(-1), entries.place]).toEqual([1, ['dialog'], 0]);
  });

  it('knows what is opened while the entry of the one before is being left', () => {
    const close = open('menu');
    settle();
    close();
    vi.advanceTimersByTime(2); // on its way back
    open('dialog');
    settle();
    expect([entries.place, press(-1)]).toEqual([1, ['dialog']]);
  });

  it('closes what lies over a page with an address, and then is the page’s', () => {
    back.push({ page: 1 }, '#page');
    open('dialog');
    settle();
    expect([entries.place, press(-1), entries.state]).toEqual([2, ['dialog'], { page: 1, steps: 1 }]);
  });

  it('passes over the entry of a menu from which a page was opened', () => {
    const close = open('menu');
    settle();
    close();
    back.push({}, '#page');
    settle();
    expect(entries.place).toBe(2);
    expect([press(-1), entries.place]).toEqual([[], 0]);
  });

  it('is asked again by what refuses to close', () => {
    let asked = 0;
    back.add(() => (asked += 1));
    settle();
    press(-1);
    press(-1);
    expect([asked, entries.place]).toEqual([2, 1]);
  });

  it('is the host’s in a frame', () => {
    back = new Back(() => true);
    open('dialog')();
    open('dialog');
    settle();
    expect([entries.place, press(-1)]).toEqual([0, []]);
  });

  it('waits for no way that leads nowhere', () => {
    entries.go = () => undefined;
    back.leave(1);
    const act = vi.fn();
    back.whenStill(act);
    expect(act).not.toHaveBeenCalled();
    vi.advanceTimersByTime(1000);
    expect(act).toHaveBeenCalledOnce();
  });
});
