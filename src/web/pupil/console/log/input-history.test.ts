import { describe, expect, it } from 'vitest';

import { InputHistory } from './input-history';

describe('the history of the input line', () => {
  it('goes back through the sent lines and forward to what was being typed', () => {
    const history = new InputHistory();
    for (const line of ['a = 1', 'b = 2', 'b = 2', ' ']) history.add(line);
    expect(history.earlier('pri')).toBe('b = 2');
    expect(history.earlier('b = 2')).toBe('a = 1');
    expect(history.earlier('a = 1')).toBe('a = 1');
    expect(history.later('a = 1')).toBe('b = 2');
    expect(history.later('b = 2')).toBe('pri');
    expect(history.later('pri')).toBe('pri');
  });

  it('leaves the field as it is when nothing has been sent', () => {
    const history = new InputHistory();
    expect(history.earlier('x')).toBe('x');
    expect(history.later('x')).toBe('x');
  });

  it('keeps the last 50 lines', () => {
    const history = new InputHistory();
    for (let i = 0; i < 60; i += 1) history.add(`line ${i}`);
    let shown = '';
    for (let i = 0; i < 60; i += 1) shown = history.earlier(shown);
    expect(shown).toBe('line 10');
  });
});
