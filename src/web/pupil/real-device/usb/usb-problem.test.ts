import { describe, expect, it } from 'vitest';

import { HexError, usbProblem } from './usb-problem';

/** An error as the library throws it. */
const error = (code: string, message = ''): Error => Object.assign(new Error(message), { code });

describe('the problem behind an error of the USB library', () => {
  it.each([
    ['device-in-use', 'Unable to claim interface.', { kind: 'in-use' }],
    ['firmware-update-required', 'No valid interfaces found.', { kind: 'old-interface' }],
    ['connection-error', 'Could not recognise the Board ID 1234', { kind: 'not-a-board' }],
    ['connection-error', 'Access to the feature "usb" is disallowed by permissions policy.', { kind: 'frame' }],
    ['connection-error', 'A transfer error has occurred.', { kind: 'line' }],
    ['unsupported', 'Connection type not supported', { kind: 'browser' }],
    ['not-connected', 'Not connected', { kind: 'unplugged', isTouched: false }],
    ['device-disconnected', 'The device was disconnected.', { kind: 'unplugged', isTouched: true }],
    ['timeout', 'Wait timed out', { kind: 'silent' }],
    ['a code of a later version', '', { kind: 'line' }],
  ])('%s: %s', (code, message, problem) => expect(usbProblem(error(code, message))).toEqual(problem));

  it('is none when nothing was chosen in the browser’s list', () => {
    expect(usbProblem(error('no-device-selected', 'No device selected.'))).toBeNull();
  });

  it('is our own where the hex could not be made', () => {
    const problem = { kind: 'too-large', missingBytes: 128, large: ['main.py'] } as const;
    expect(usbProblem(new HexError(problem))).toBe(problem);
  });

  it('is one of the line for anything else that is thrown', () => {
    expect(usbProblem('rubbish')).toEqual({ kind: 'line' });
    expect(usbProblem({})).toEqual({ kind: 'line' });
  });
});
