export declare function folded(word: string): string;
export declare function listed(): Promise<Set<string>>;
export declare function names(languages: number, words: number): string[];
export declare function held(fragments: ReadonlySet<string>, names: readonly string[]): Set<string>;
