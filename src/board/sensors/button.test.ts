import { describe, expect, it } from 'vitest';
import { createBench } from '../testing/bench';

describe('a button', () => {
  it('B1: is seen 36 ms after the press and 44 ms after the release', () => {
    const { board, passMs, waitUntil } = createBench();
    const { buttonA } = board;
    buttonA.press();
    expect(waitUntil(() => buttonA.isPressed())).toBe(36);
    passMs(64);
    buttonA.release();
    expect(waitUntil(() => !buttonA.isPressed())).toBe(144);
  });

  it('B1: shows the contact itself at once', () => {
    const { buttonA } = createBench().board;
    buttonA.press();
    expect(buttonA.isDown).toBe(true);
    expect(buttonA.isPressed()).toBe(false);
  });

  it('B2: a press of 32 ms is not seen, one of 36 ms is', () => {
    const { board, passMs } = createBench();
    const { buttonA } = board;
    buttonA.press();
    passMs(32);
    buttonA.release();
    passMs(200);
    expect(buttonA.takePresses()).toBe(0);
    buttonA.press();
    passMs(36);
    buttonA.release();
    passMs(200);
    expect(buttonA.takePresses()).toBe(1);
  });

  it('B3: counting the presses does not forget that there was one, nor the other way round', () => {
    const { board, passMs } = createBench();
    const { buttonB } = board;
    for (let press = 0; press < 3; press++) {
      buttonB.press();
      passMs(60);
      buttonB.release();
      passMs(60);
    }
    expect(buttonB.wasPressed()).toBe(true);
    expect(buttonB.wasPressed()).toBe(false);
    expect(buttonB.takePresses()).toBe(3);
    expect(buttonB.takePresses()).toBe(0);
  });

  it('B4: pulls its wire low, and a chip that does the same presses it', () => {
    const { board, chip, waitUntil } = createBench();
    expect(board.wire('P5').level).toBe(1);
    board.buttonA.press();
    expect(board.wire('P5').level).toBe(0);
    chip('P11').drive(0);
    expect(waitUntil(() => board.buttonB.isPressed())).toBe(36);
  });
});

describe('a touch pad', () => {
  it('B5: is debounced like a button: 36 ms and 44 ms', () => {
    const { board, passMs, waitUntil } = createBench();
    const logo = board.touch.get('pin_logo')!;
    logo.press();
    expect(logo.isTouched()).toBe(false);
    expect(waitUntil(() => logo.isTouched())).toBe(36);
    passMs(64);
    logo.release();
    expect(waitUntil(() => !logo.isTouched())).toBe(144);
    expect([logo.wasTouched(), logo.takeTouches()]).toEqual([true, 1]);
  });

  it('B5: there are four of them on the micro:bit', () => {
    expect([...createBench().board.touch.keys()]).toEqual(['pin0', 'pin1', 'pin2', 'pin_logo']);
  });

  it('B6: pin 0 feels a chip that pulls it low while it is used for touching, and not before', () => {
    const { board, chip, passMs } = createBench();
    const pad = board.touch.get('pin0')!;
    chip('P0').drive(0);
    passMs(100);
    expect(pad.isTouched()).toBe(false);
    expect(pad.pin.mode).toBe('touch');
    passMs(36);
    expect(pad.isTouched()).toBe(true);
  });

  it('B6: nobody touches a pad on which nothing pulls, and a capacitive one feels only fingers', () => {
    const { board, chip, passMs } = createBench();
    const pad = board.touch.get('pin1')!;
    pad.isTouched();
    passMs(100);
    expect(pad.isTouched()).toBe(false);
    pad.kind = 'capacitive';
    chip('P1').drive(0);
    passMs(100);
    expect(pad.isTouched()).toBe(false);
    pad.press();
    passMs(36);
    expect(pad.isTouched()).toBe(true);
  });
});
