import { describe, expect, it } from 'vitest';
import { plainText, unseenShown } from './unseen';

describe('a text from elsewhere', () => {
  it('has its signs that turn it around, or that nobody sees, shown', () => {
    expect(unseenShown('an\u202ena \u200bBen\ufeff')).toBe('an⟨U+202E⟩na ⟨U+200B⟩Ben⟨U+FEFF⟩');
    expect(unseenShown('a\u{e0041}b\u3164c\u00add\u2028')).toBe('a⟨U+E0041⟩b⟨U+3164⟩c⟨U+00AD⟩d⟨U+2028⟩');
  });

  it('stays as it is in every language, with pictures that are joined of several', () => {
    for (const text of ['Zoë Öz, Çelik', 'نور', 'नूर', '山田', '👩‍🔧 👍🏽', 'a\tb\nc', 'à 5 %'])
      expect(unseenShown(text)).toBe(text);
  });

  it('does not steer what shows it', () => {
    expect(plainText('a\u001b[2Jb\0c\r\n\u009b')).toBe('a⟨U+001B⟩[2Jb⟨U+0000⟩c\r\n⟨U+009B⟩');
  });
});
