/// <reference types="vite/types/importMeta.d.ts" />
// What the rooms may use although they have neither the DOM's nor Node's type library.

/** Text assets (Python libraries, drawings) are bundled as strings. */
declare module '*?raw' {
  const text: string;
  export default text;
}
