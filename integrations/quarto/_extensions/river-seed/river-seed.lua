-- The shortcode of Quarto: {{< river-seed kauri >}}. It draws each picture once, with the command `riverseed`, into the folder riverseed
-- of the project, where the element's files are.

-- The longer side of the picture, a PNG of some 600 kB.
local SIZE = "960"
-- Pixels of a screen to a CSS pixel, in a column of 640: letters are large enough to be read.
local RATIO = "1.5"

local function fail(message)
  error("river-seed: " .. message, 0)
end

local function escaped(text)
  return (text:gsub("[&<>\"']", function(sign) return "&#" .. sign:byte() .. ";" end))
end

-- Draws a link with the command, without a shell, so that no word is read as one. What is wrong with a link the command says itself.
local function draw(map, link, path)
  local is_done, why = pcall(pandoc.pipe, "riverseed", { "render", link, "-o", path, "--size", SIZE, "--ratio", RATIO }, "")
  if is_done then return end
  if type(why) == "table" and why.error_code ~= 127 then fail('no map of "' .. map .. '": see above') end
  fail("the command `riverseed` cannot be run: " .. tostring(why))
end

-- Returns the size that a PNG says it has; nothing if there is none.
local function size_of(path)
  local file = io.open(path, "rb")
  if not file then return end
  local head = file:read(24)
  file:close()
  return string.unpack(">I4I4", head, 17)
end

-- Returns the seed of a link, as text.
local function seed_of(link)
  local seed = ("&" .. link:gsub("^%?", "")):match("&seed=([^&]*)") or "kauri"
  return (seed:gsub("+", " "):gsub("%%(%x%x)", function(code) return string.char(tonumber(code, 16)) end))
end

local function link_of(map)
  if map:match("^%??[a-z][a-z-]*=") then return map end
  return "seed=" .. map:gsub("[^%w]", function(sign) return ("%%%02X"):format(sign:byte()) end)
end

local edition

-- Returns the edition of the algorithms that the command draws.
local function edition_of_command()
  if edition then return edition end
  local is_done, said = pcall(pandoc.pipe, "riverseed", { "table", "--json" }, "")
  if not is_done then fail("the command `riverseed` cannot be run: " .. tostring(said)) end
  edition = said:match('"key": "edition".-"default": "(%d+)"') or fail("the command `riverseed` names no edition: another version is needed")
  return edition
end

-- Names the edition in a link that names none, so that the element draws what the picture shows after an upgrade too.
local function pinned(link)
  if ("&" .. link:gsub("^%?", "")):match("&edition=") then return link end
  return link .. "&edition=" .. edition_of_command()
end

-- Returns the file name and the size of a map's picture in a folder. The name is a hash of all that decides the pixels.
local function picture(map, link, folder)
  local pixels = ("%s edition %s, %s at %s"):format(map, edition_of_command(), SIZE, RATIO)
  local name = "river-seed-" .. pandoc.utils.sha1(pixels):sub(1, 16) .. ".png"
  if not size_of(folder .. name) then draw(map, link, folder .. name) end
  return name, size_of(folder .. name)
end

local function river_seed(args, kwargs)
  local map = pandoc.utils.stringify(args[1] or "")
  local own_alt = pandoc.utils.stringify(kwargs.alt or "")
  if map:match("^%s*$") then fail('a word or a link is wanted, as "kauri" or "seed=kauri&land=valley"') end
  if map:match("%c") then fail("the map holds a character that cannot be shown") end
  local folder = (quarto.project.directory or ".") .. "/riverseed/"
  if not io.open(folder .. "river-seed.js") then fail("the element's files are not in the folder riverseed of the project") end

  local link = pinned(link_of(map))
  local name, width, height = picture(map, link, folder)
  local base = (quarto.project.offset or ".") .. "/riverseed/"
  local alt = own_alt ~= "" and own_alt or "Rivers grown from “" .. seed_of(link) .. "”"
  if not quarto.doc.is_format("html") then return pandoc.Image({ pandoc.Str(alt) }, base .. name) end
  return pandoc.RawInline("html", table.concat({
    '<script type="module" src="', base, 'river-seed.js"></script>',
    '<river-seed recipe="', escaped(link), '"', own_alt ~= "" and ' alt="' .. escaped(alt) .. '"' or "", ' style="display:block">',
    '<img src="', base, name, '" alt="', escaped(alt), '" width="', width, '" height="', height,
    '" style="display:block;width:100%;height:auto"></river-seed>',
  }))
end

return { ["river-seed"] = river_seed }
