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
