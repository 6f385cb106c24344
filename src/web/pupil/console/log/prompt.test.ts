import { describe, expect, it } from 'vitest';

import { ConsoleLog } from './console-log';
import { promptOf } from './prompt';

describe('the prompt beside the field', () => {
  it('is >>> before a line, and ... inside of a block', () => {
    const log = new ConsoleLog();
    log.write('>>> ');
    expect(promptOf(log.entries)).toBe('>>>');
    log.write('def f(x):\r\n...     ');
    expect(promptOf(log.entries)).toBe('...');
    log.write('return x\r\n... \r\n>>> ');
    expect(promptOf(log.entries)).toBe('>>>');
  });

  it('is >>> while nothing has been written', () => {
    expect(promptOf([])).toBe('>>>');
  });
});
