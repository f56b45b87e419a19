export declare function folded(word: string): string;
export declare function listed(): Promise<Set<string>>;
export declare function hashes(): Promise<string>;
