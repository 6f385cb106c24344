import { describe, expect, it } from 'vitest';
import { frameCheckParts, scriptHash, withFrameCheck } from './frame-check.mjs';
import { inlineComment, inlineScript, inlineStyle, singleFile } from './single-file.mjs';

const PAGE = `<!doctype html>
<html lang="de">
  <head>
    <meta http-equiv="Content-Security-Policy" content="default-src 'self'; script-src 'self' 'wasm-unsafe-eval'" />
    <link rel="icon" type="image/svg+xml" href="./logo.svg" />
    <title>Parcours</title>
    <script type="module" src="./main.ts"></script>
  </head>
  <body>
    <div id="app"></div>
  </body>
</html>
`;
const single = (script) => singleFile(PAGE, { script, css: 'p{}', icon: '<svg/>', licences: 'MIT' });

describe('code inside a page', () => {
  it('cannot end its element, nor hide its end', () => {
    const text = 'a</script><!--<script></SCRIPT>';
    const code = inlineScript(`result = ${JSON.stringify(text)}`);
    expect(code).not.toMatch(/<\/script|<script|<!--/i);
    expect(new Function('let result; return ' + code)()).toBe(text);
  });

  it('of styles cannot either', () => {
    expect(inlineStyle('a::after{content:"</style>"}')).not.toContain('</style');
  });
});

describe('a text in a comment', () => {
  it('cannot end it', () => {
    const inside = inlineComment(`one --> two --!> three ${'-'.repeat(80)}`);
    expect(inside).not.toMatch(/--!?>/);
    expect(inside).toContain('-'.repeat(80));
  });
});

describe('the single file', () => {
  it('carries the licences of its parts, behind the page', () => {
    expect(single('run()')).toMatch(/<\/html>\n<!--\nMIT\n-->\n$/);
  });

  it('asks for no other file', () => {
    expect(single('run()')).not.toMatch(/(src|href)="(?!data:)/);
  });

  it('allows its own script alone, by its hash', () => {
    const page = single('run("$&")');
    const script = /<script>([^]*)<\/script>/.exec(page)[1];
    expect(script.trim()).toBe('run("$&")');
    expect(page).toContain(`script-src ${scriptHash(script)} 'wasm-unsafe-eval'`);
    expect(page).toContain("connect-src 'none'");
  });

  it('runs its script when the page is there', () => {
    const page = single('run()');
    expect(page.indexOf('<script>')).toBeGreaterThan(page.indexOf('id="app"'));
  });

  it('is not made of a page that looks otherwise', () => {
    expect(() => singleFile('<p>', { script: '', css: '', icon: '', licences: '' })).toThrow(/nothing like/);
  });
});

describe('the check for frames', () => {
  it('has a sentence in each of the four languages', async () => {
    const { html } = await frameCheckParts();
    expect(Array.from(html.matchAll(/<p lang="(\w\w)">/g), ([, language]) => language)).toEqual([
      'de',
      'fr',
      'it',
      'en',
    ]);
  });

  it('is allowed by the page that it stands in', async () => {
    const parts = await frameCheckParts();
    const page = withFrameCheck(PAGE, parts);
    expect(page).toContain(`script-src 'self' ${scriptHash(parts.script)} 'wasm-unsafe-eval'`);
    expect(page).toContain(`<script>${parts.script}</script>`);
    expect(page).toContain('<div id="app"><div class="cannot-start"');
  });
});
