import { StrictMode, useState } from "react";
import { createRoot } from "react-dom/client";
import type {} from "riverseed/react";
import "riverseed/define";

function Post() {
  const [word, setWord] = useState("kauri");
  const [news, setNews] = useState("");
  return (
    <>
      <input aria-label="Word" value={word} onChange={(event) => setWord(event.target.value)} />
      <river-seed
        seed={word}
        attractors={300}
        river-width={20}
        loading="eager"
        oncomplete={({ detail }) => setNews(`${detail.summary.sources} sources`)}
      />
      <output>{news}</output>
    </>
  );
}

const main = document.querySelector("main");
if (main)
  createRoot(main).render(
    <StrictMode>
      <Post />
    </StrictMode>,
  );
