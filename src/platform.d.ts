// Parts of the platform that browsers and Node share and that the rooms' plain ES library does not declare.

declare namespace WebAssembly {
  /** A compiled .wasm file. */
  class Module {
    constructor(bytes: ArrayBufferView | ArrayBuffer);
  }
  /** Linear memory; `buffer` is a new object after the memory grew. */
  class Memory {
    readonly buffer: ArrayBuffer;
  }
  class Global {
    value: number;
  }
  /** Thrown by a compiled program that does something forbidden. */
  class RuntimeError extends Error {}
  class Instance {
    constructor(module: Module, imports: Readonly<Record<string, Readonly<Record<string, unknown>>>>);
    readonly exports: Readonly<Record<string, unknown>>;
  }
}

declare class TextDecoder {
  constructor(label?: string, options?: { readonly fatal?: boolean; readonly ignoreBOM?: boolean });
  decode(bytes?: Uint8Array, options?: { readonly stream?: boolean }): string;
}

declare class TextEncoder {
  encode(text: string): Uint8Array;
}

/** The bytes of a base64 text, one per character. */
declare function atob(base64: string): string;

/** A text of bytes, one per character, as base64. */
declare function btoa(bytes: string): string;
