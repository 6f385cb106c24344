import { describe, expect, it } from 'vitest';
import { handInOfBytes } from './contents';

const none = () => null;

describe('a file that is handed in', () => {
  it('is told to be no program where it is a picture, not to be no text', () => {
    const picture = Uint8Array.of(0xff, 0xd8, 0xff, 0xe0);
    expect(handInOfBytes('Foto.jpg', picture, none)).toMatchObject({ problem: { code: 'kind' } });
    expect(handInOfBytes('anna.py', picture, none)).toMatchObject({ problem: { code: 'not-text' } });
  });

  it('may be a program from an editor of Windows, with its mark at the beginning', () => {
    const content = handInOfBytes('anna.py', new TextEncoder().encode('\ufeffx = 1\r\n'), none);
    expect(content).toMatchObject({ handIn: { project: { files: [{ name: 'main.py', text: 'x = 1\r\n' }] } } });
  });
});
