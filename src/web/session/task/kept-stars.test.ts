// @vitest-environment happy-dom
import { beforeEach, describe, expect, it } from 'vitest';

import { createKeptStars } from './kept-stars';

beforeEach(() => localStorage.clear());

describe('the stars of a browser', () => {
  it('are the best of all tries', () => {
    const stars = createKeptStars(localStorage);
    stars.keep('forward-callibot', 2);
    stars.keep('forward-callibot', 1);
    stars.keep('corner-callibot', 3);
    expect(stars.all.value).toEqual({ 'forward-callibot': 2, 'corner-callibot': 3 });
  });

  it('are there on the next visit', () => {
    createKeptStars(localStorage).keep('corner-callibot', 3);
    expect(createKeptStars(localStorage).all.value).toEqual({ 'corner-callibot': 3 });
  });

  it('lose nothing that another tab has won meanwhile', () => {
    const [one, other] = [createKeptStars(localStorage), createKeptStars(localStorage)];
    one.keep('a', 1);
    other.keep('b', 2);
    expect(createKeptStars(localStorage).all.value).toEqual({ a: 1, b: 2 });
  });

  it('are none where what is stored makes no sense, entry by entry', () => {
    localStorage.setItem('parcours.stars', '{"a": 3, "b": 9, "c": "x"}');
    expect(createKeptStars(localStorage).all.value).toEqual({ a: 3 });
    localStorage.setItem('parcours.stars', 'no');
    expect(createKeptStars(localStorage).all.value).toEqual({});
  });

  it('hold as long as the page where nothing may be stored', () => {
    const stars = createKeptStars(null);
    stars.keep('a', 2);
    expect(stars.all.value).toEqual({ a: 2 });
    expect(localStorage.length).toBe(0);
  });
});
