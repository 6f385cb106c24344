import { describe, expect, it } from 'vitest';

import { createSoftKeyboard } from './soft-keyboard';

describe('the soft keyboard', () => {
  it('is up when it takes 260 of 640 px, and down when they are back', () => {
    const keyboard = createSoftKeyboard();
    keyboard.see(360, 640);
    expect(keyboard.isUp).toBeNull();
    keyboard.see(360, 380);
    expect(keyboard.isUp).toBe(true);
    keyboard.see(360, 640);
    expect(keyboard.isUp).toBe(false);
  });

  it('is not mistaken for the bar of the browser, which takes 56 px', () => {
    const keyboard = createSoftKeyboard();
    keyboard.see(360, 640);
    keyboard.see(360, 584);
    expect(keyboard.isUp).toBeNull();
  });

  it('is unknown after the phone was turned, until the window grows or shrinks again', () => {
    const keyboard = createSoftKeyboard();
    keyboard.see(360, 640);
    keyboard.see(360, 380);
    keyboard.see(640, 160);
    expect(keyboard.isUp).toBeNull();
    keyboard.see(640, 360);
    expect(keyboard.isUp).toBeNull();
    keyboard.see(640, 160);
    expect(keyboard.isUp).toBe(true);
  });
});
