import "riverseed/define";

const river = document.createElement("river-seed");
const word = document.createElement("input");
const news = document.createElement("output");

river.seed = "kauri";
river.attractors = 300;
river.riverWidth = 20;
river.loading = "eager";
river.addEventListener("complete", ({ detail }) => {
  news.textContent = `${detail.summary.sources} sources`;
});

word.value = river.seed;
word.ariaLabel = "Word";
word.addEventListener("change", () => {
  river.seed = word.value;
});
document.querySelector("main")?.append(word, river, news);
