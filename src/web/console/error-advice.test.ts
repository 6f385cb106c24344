import { describe, expect, it } from 'vitest';

import { adviceFor } from './error-advice';

describe('advice for an error', () => {
  it('names the unknown name', () => {
    expect(adviceFor({ type: 'NameError', message: "name 'irLinks' isn't defined" })).toEqual({
      key: 'error.NameError',
      values: { name: 'irLinks' },
      device: "NameError: name 'irLinks' isn't defined",
    });
  });

  it('names the missing attribute, not its object', () => {
    const advice = adviceFor({ type: 'AttributeError', message: "'module' object has no attribute 'forwards'" });
    expect(advice.values).toEqual({ name: 'forwards' });
  });

  it('asks whether the robot is plugged in when an address does not answer (OSError 19)', () => {
    expect(adviceFor({ type: 'OSError', message: '[Errno 19] ENODEV' }).key).toBe('error.noDevice');
    expect(adviceFor({ type: 'OSError', message: '19' }).key).toBe('error.noDevice');
    expect(adviceFor({ type: 'OSError', message: '[Errno 2] ENOENT' }).key).toBe('error.noFile');
  });

  it('knows endless recursion among the runtime errors', () => {
    expect(adviceFor({ type: 'RuntimeError', message: 'maximum recursion depth exceeded' }).key).toBe(
      'error.recursion',
    );
  });

  it('says that the program is too long where the board has no room for its text', () => {
    const traceback =
      'MemoryError: …\nmain.py: the program is too long for the board. It has 65800 characters; about 20000 fit.\n';
    expect(adviceFor({ type: 'MemoryError', message: '', traceback }).key).toBe('error.tooLong');
    expect(adviceFor({ type: 'MemoryError', message: '', traceback: 'MemoryError: \n' }).key).toBe('error.MemoryError');
  });

  it('has something to say about an exception it does not know', () => {
    expect(adviceFor({ type: 'PupilError', message: '' })).toEqual({
      key: 'error.other',
      values: {},
      device: 'PupilError',
    });
  });
});
