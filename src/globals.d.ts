/// <reference types="vite/types/importMeta.d.ts" />
// What the rooms may use although they have neither the DOM's nor Node's type library.

/** Text assets (Python libraries, drawings) are bundled as strings. */
declare module '*?raw' {
  const text: string;
  export default text;
}

/** A course that comes with the app (`build/scenes.ts`). */
declare module '*.json?scene' {
  import type { Scene } from '#scene/scene';
  const scene: Scene;
  export default scene;
}

/** A program that comes with the app, in every language (`build/programs.ts`). */
declare module '*.py?languages' {
  import type { Texts } from '#core/languages';
  const program: { readonly file: string; readonly title: Texts; readonly source: Texts };
  export default program;
}

/** The page's words, which come one language at a time (`build/words.ts`); empty where all languages are in its parts. */
declare module 'virtual:word-files' {
  import type { Language } from '#core/languages';
  type Loader = () => Promise<{ readonly wordTexts: readonly (readonly string[])[] }>;
  const files: Readonly<Record<string, Readonly<Record<Language, Loader>>>>;
  export default files;
}
